// A text under reading: its name, its limits and their use so far, and its refusals.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/limits.hpp"
#include "reference/error.hpp"

namespace minkref {

class Input {
 public:
  Input(std::string source, const ReadLimits& limits)
      : source_(std::move(source)), limits_(limits) {}
  /// A part of `whole` under its own name; both draw on the same limits. `whole` must outlive it.
  Input(std::string source, Input& whole)
      : source_(std::move(source)), limits_(whole.limits_), used_(whole.used_) {}
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  const ReadLimits& limits() const { return limits_; }
  const std::string& source() const { return source_; }

  /// Throws BadInput with this source's name. `line` 0: none.
  [[noreturn]] void refuse(const std::string& code, const std::string& problem,
                           const std::string& mend, Place place) const;
  [[noreturn]] void refuse(const std::string& code, const std::string& problem,
                           const std::string& mend, std::size_t line = 0) const;
  /// Throws LimitExceeded with this source's name.
  [[noreturn]] void exceed(const std::string& code, const std::string& problem,
                           const std::string& mend, Place place) const;

  /// The exact number that a token names, charged to `number_bytes`. Refusals carry `place`.
  Rational number(std::string_view token, const Place& place);
  /// The exact value of a double, charged likewise. Refuses NaN and infinity ("not-a-number").
  Rational number(double value, const Place& place);

  /// The decimal digits of a count or an index, no sign. Refuses other tokens ("syntax"); `what`
  /// like "a number of rings".
  std::size_t whole_number(std::string_view token, const char* what, const Place& place) const;

  /// Charges one vertex.
  void count_vertex(const Place& place);
  /// Charge a face, and a vertex of a face.
  void count_face(const Place& place);
  void count_face_corner(const Place& place);

  /// Keeps the first hundred warnings and counts the rest, without need for their text.
  bool keeps_warnings() const { return warnings_.size() < 100; }
  void warn(std::size_t line, const std::string& text);
  std::vector<std::string> take_warnings();

 private:
  struct Used {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t face_corners = 0;
    std::size_t number_bytes = 0;
  };

  void charge(const Rational& value, const Place& place);
  Place named(Place place) const;

  std::string source_;
  const ReadLimits& limits_;
  Used own_;
  Used& used_ = own_;
  std::vector<std::string> warnings_;
  std::size_t more_warnings_ = 0;
};

/// A place within a text. `line` 0: none.
Place at_line(std::size_t line);

}  // namespace minkref
