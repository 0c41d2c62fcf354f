#include "formats/input.hpp"

#include <gmp.h>

#include <charconv>
#include <system_error>
#include <utility>

#include "formats/message_text.hpp"
#include "reference/interrupt.hpp"

namespace minkref {
namespace {

std::size_t bytes_of(const Rational& value) {
  const mpq_srcptr q = value.backend().data();
  return (mpz_size(mpq_numref(q)) + mpz_size(mpq_denref(q))) * sizeof(mp_limb_t);
}

}  // namespace

Place at_line(std::size_t line) {
  Place place;
  if (line > 0) place.line = line;
  return place;
}

Place Input::named(Place place) const {
  if (place.source.empty()) place.source = source_;
  return place;
}

void Input::refuse(const std::string& code, const std::string& problem, const std::string& mend,
                   Place place) const {
  throw BadInput(code, problem, mend, named(std::move(place)));
}

void Input::refuse(const std::string& code, const std::string& problem, const std::string& mend,
                   std::size_t line) const {
  refuse(code, problem, mend, at_line(line));
}

void Input::exceed(const std::string& code, const std::string& problem, const std::string& mend,
                   Place place) const {
  throw LimitExceeded(code, problem, mend, named(std::move(place)));
}

void Input::charge(const Rational& value, const Place& place) {
  used_.number_bytes += bytes_of(value);
  if (used_.number_bytes > limits_.number_bytes) {
    exceed(
        "too-many-digits",
        "the numbers up to here take more than " + std::to_string(limits_.number_bytes) + " bytes",
        "use shorter numbers, or raise the limit on the memory of numbers", place);
  }
}

Rational Input::number(std::string_view token, const Place& place) {
  Rational value;
  try {
    value = parse_rational(token, limits_.number);
  } catch (const LimitExceeded& e) {
    exceed(e.code(), printable(e.problem()), e.mend(), place);
  } catch (const BadInput& e) {
    refuse(e.code(), printable(e.problem()), e.mend(), place);
  }
  charge(value, place);
  return value;
}

Rational Input::number(double value, const Place& place) {
  Rational exact;
  try {
    exact = from_double(value);
  } catch (const BadInput& e) {
    refuse(e.code(), e.problem(), e.mend(), place);
  }
  charge(exact, place);
  return exact;
}

std::size_t Input::whole_number(std::string_view token, const char* what,
                                const Place& place) const {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc{} || end != token.data() + token.size()) {
    refuse("syntax", in_quotes(token) + " is not " + what, "write a whole number", place);
  }
  return value;
}

void Input::count_vertex(const Place& place) {
  look_for_interrupt();
  if (++used_.vertices > limits_.vertices) {
    exceed("too-many-vertices",
           "there are more than " + std::to_string(limits_.vertices) + " vertices",
           "simplify the input, or raise the limit on vertices", place);
  }
}

void Input::count_face(const Place& place) {
  look_for_interrupt();
  if (++used_.faces > limits_.faces) {
    exceed("too-many-faces", "there are more than " + std::to_string(limits_.faces) + " faces",
           "simplify the input, or raise the limit on faces", place);
  }
}

void Input::count_face_corner(const Place& place) {
  look_for_interrupt();
  if (++used_.face_corners > limits_.face_corners) {
    exceed("too-many-face-corners",
           "the faces have more than " + std::to_string(limits_.face_corners) +
               " vertices, each counted in every face",
           "simplify the input, or raise the limit on the vertices of faces", place);
  }
}

void Input::warn(std::size_t line, const std::string& text) {
  if (!keeps_warnings()) {
    ++more_warnings_;
    return;
  }
  std::string warning = source_.empty() ? "" : source_ + ": ";
  if (line > 0) warning += "line " + std::to_string(line) + ": ";
  warnings_.push_back(warning + text);
}

std::vector<std::string> Input::take_warnings() {
  if (more_warnings_ > 0) {
    warnings_.push_back("and " + std::to_string(more_warnings_) + " more warnings of this kind");
  }
  more_warnings_ = 0;
  return std::exchange(warnings_, {});
}

}  // namespace minkref
