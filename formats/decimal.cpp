#include "formats/decimal.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "formats/message_text.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref {
namespace {

/// Divides all factors `prime` out of `value` and returns their number.
unsigned long remove_factor(Integer& value, unsigned long prime) {
  const Integer factor(prime);
  return mpz_remove(value.backend().data(), value.backend().data(), factor.backend().data());
}

}  // namespace

std::optional<std::string> exact_decimal(const Rational& value) {
  look_for_interrupt();
  Integer rest = denominator(value);
  const unsigned long twos = remove_factor(rest, 2);
  const unsigned long fives = remove_factor(rest, 5);
  if (rest != 1) return std::nullopt;
  const unsigned long places = std::max(twos, fives);
  // numerator / (2^a 5^b) = numerator * 2^(k-a) 5^(k-b) / 10^k
  Integer scaled, factor;
  mpz_mul_2exp(scaled.backend().data(), numerator(value).backend().data(), places - twos);
  mpz_ui_pow_ui(factor.backend().data(), 5, places - fives);
  scaled *= factor;
  std::string digits = abs(scaled).str();
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return (sign(value) < 0 ? "-" : "") + digits;
}

bool has_exact_decimal(const Rational& value) {
  Integer rest = denominator(value);
  remove_factor(rest, 2);
  remove_factor(rest, 5);
  return rest == 1;
}

std::string decimal(const Rational& value) {
  if (auto exact = exact_decimal(value)) return *std::move(exact);
  const double nearest = to_double(value);
  if (nearest == 0 || !std::isfinite(nearest)) {
    throw LimitExceeded("not-representable",
                        in_quotes(to_string(value)) +
                            " has no finite decimal expansion and is beyond the range of doubles",
                        "write the set as JSON, which is exact");
  }
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), nearest,
                                 std::chars_format::general, 17);
  return {text.data(), end.ptr};
}

}  // namespace minkref
