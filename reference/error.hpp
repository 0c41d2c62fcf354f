// The exception hierarchy of the library's border. Every error names its input.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace minkref {

/// Root of everything the library throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The place of a fault within an input. Fields that do not apply stay empty.
struct Place {
  std::string source;                       ///< file name, or "P", "Q"
  std::optional<std::size_t> line;          ///< 1-based line of a text file
  std::optional<std::size_t> ring;          ///< 0-based, in the order of the input
  std::optional<std::size_t> face;          ///< of a polyhedron, 0-based
  std::vector<std::size_t> vertices;        ///< 0-based indices within the ring, or of a polyhedron
  std::vector<std::string> coordinates;     ///< "(x, y)" or "(x, y, z)" of `vertices`, exact
  std::optional<std::size_t> other_face;    ///< second face, where two are involved
  std::optional<std::size_t> other_ring;    ///< second ring, where two are involved
  std::vector<std::size_t> other_vertices;  ///< 0-based indices within the second ring
};

/// The refusal of an input: `code` is a stable word (for example "self-intersection"), `problem`
/// says the fault as one sentence, `mend` says how to put it right. what() joins place, problem and
/// mend.
class BadInput : public Error {
 public:
  BadInput(std::string code, std::string problem, std::string mend, Place place = {});
  const std::string& code() const { return code_; }
  const std::string& problem() const { return problem_; }
  const std::string& mend() const { return mend_; }
  const Place& place() const { return place_; }
  /// The same refusal, with an empty source (file name) filled in.
  BadInput from(const std::string& source) const;

 private:
  std::string code_, problem_, mend_;
  Place place_;
};

/// An interval (or another certifying arithmetic) could not prove a sign.
class UndecidedSign : public Error {
 public:
  UndecidedSign() : Error("the sign is not decided by this arithmetic") {}
};

/// A stated limit (digits, exponent, depth, memory) was reached.
class LimitExceeded : public BadInput {
 public:
  using BadInput::BadInput;
};

}  // namespace minkref
