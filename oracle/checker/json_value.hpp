// JSON as a checker wants it: numbers keep their text, no member twice, no floating point.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace minkref::checker {

/// Exit codes.
enum class Code { verified = 0, refuted = 1, malformed = 2, out_of_budget = 4 };

struct NotVerified : std::runtime_error {
  Code code;
  NotVerified(Code why, const std::string& what) : std::runtime_error(what), code(why) {}
};

inline void demand(bool condition, const std::string& what, Code code = Code::refuted) {
  if (!condition) throw NotVerified(code, what);
}
inline void require(bool condition, const std::string& what) {
  demand(condition, what, Code::malformed);
}

struct Member;

struct Value {
  enum class Kind { null, boolean, integer, real, text, list, object } kind = Kind::null;
  bool truth = false;
  std::string text;  ///< of a text, and of a number as it stands
  std::vector<Value> items;
  std::vector<Member> members;

  bool is_null() const { return kind == Kind::null; }
};

struct Member {
  std::string name;
  Value value;
};

constexpr std::size_t most_digits = 100'000;  ///< of one number

/// The value that a text is, in UTF-8. Throws NotVerified (malformed): also for a member that
/// occurs twice, for what comes after the value, for more than 500 levels, for escapes of
/// surrogates, and for numbers with a point or an exponent unless `reals`.
Value parse_json(std::string_view text, bool reals);

/// A value as one text, to be compared: two are equal iff their values are.
std::string written_out(const Value& value);

}  // namespace minkref::checker
