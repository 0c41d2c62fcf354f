#include "formats/input.hpp"

#include <gmp.h>

#include <utility>

#include "formats/message_text.hpp"

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

Rational Input::number(std::string_view token, const Place& place) {
  Rational value;
  try {
    value = parse_rational(token, limits_.number);
  } catch (const LimitExceeded& e) {
    exceed(e.code(), printable(e.problem()), e.mend(), place);
  } catch (const BadInput& e) {
    refuse(e.code(), printable(e.problem()), e.mend(), place);
  }
  used_.number_bytes += bytes_of(value);
  if (used_.number_bytes > limits_.number_bytes) {
    exceed(
        "too-many-digits",
        "the numbers up to here take more than " + std::to_string(limits_.number_bytes) + " bytes",
        "use shorter numbers, or raise the limit on the memory of numbers", place);
  }
  return value;
}

void Input::count_vertex(const Place& place) {
  if (++used_.vertices > limits_.vertices) {
    exceed("too-many-vertices",
           "there are more than " + std::to_string(limits_.vertices) + " vertices",
           "simplify the input, or raise the limit on vertices", place);
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
