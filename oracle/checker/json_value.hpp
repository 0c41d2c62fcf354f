// JSON for a checker: numbers keep their text, no member occurs twice, no floating point.
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
  std::string text;  ///< of a text, or of a number as written
  std::vector<Value> items;
  std::vector<Member> members;

  bool is_null() const { return kind == Kind::null; }
};

struct Member {
  std::string name;
  Value value;
};

constexpr std::size_t most_digits = 100'000;  ///< of one number

/// Parses a text in UTF-8. Throws NotVerified (malformed), also for a member that occurs twice, for
/// anything after the value, for more than 500 levels, for surrogate escapes, and, unless `reals`,
/// for numbers with a point or an exponent.
Value parse_json(std::string_view text, bool reals);

/// Writes a value as text for comparison: texts are equal iff the values are.
std::string written_out(const Value& value);

}  // namespace minkref::checker
