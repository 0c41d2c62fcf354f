#include "reference/space/critical/event_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace minkref::inline space {
namespace {

__extension__ typedef unsigned __int128 Word128;

std::optional<Int128> in_words(const Integer& value) {
  if (value.is_zero()) return Int128{0};
  const mpz_srcptr number = value.backend().data();
  if (mpz_sizeinbase(number, 2) > EventScale::most_bits) return std::nullopt;
  std::array<std::uint64_t, 2> words{};
  mpz_export(words.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, number);
  const auto magnitude = static_cast<Int128>(Word128{words[1]} << 64 | words[0]);
  return mpz_sgn(number) < 0 ? -magnitude : magnitude;
}

/// Within three roundings; 0 or infinite beyond doubles.
double quotient(const Integer& numerator, const Integer& denominator) {
  long top = 0, bottom = 0;
  const double a = mpz_get_d_2exp(&top, numerator.backend().data()),
               b = mpz_get_d_2exp(&bottom, denominator.backend().data());
  constexpr long most = 5000;
  return std::ldexp(a / b, static_cast<int>(std::clamp(top - bottom, -most, most)));
}

/// The product of two magnitudes: upper and lower half.
std::array<Word128, 2> product(Word128 a, Word128 b) {
  constexpr Word128 mask = (Word128{1} << 64) - 1;
  const Word128 a0 = a & mask, a1 = a >> 64, b0 = b & mask, b1 = b >> 64;
  const Word128 low = a0 * b0, first = a1 * b0 + (low >> 64), second = a0 * b1 + (first & mask);
  return {a1 * b1 + (first >> 64) + (second >> 64), (second << 64) | (low & mask)};
}

Word128 magnitude(Int128 value) {
  return value < 0 ? -static_cast<Word128>(value) : static_cast<Word128>(value);
}

}  // namespace

EventScale::EventScale(const Integer& numerator, const Integer& denominator) {
  const auto top = in_words(numerator), bottom = in_words(denominator);
  if (top && bottom) {
    *this = EventScale(*top, *bottom);
  } else {
    const bool is_negative = denominator.sign() < 0;
    const double rounded = quotient(numerator, denominator);
    long_ = is_negative ? new Long{-numerator, -denominator, rounded}
                        : new Long{numerator, denominator, rounded};
    denominator_ = 0;
  }
}

EventScale::EventScale(const Rational& value)
    : EventScale(boost::multiprecision::numerator(value),
                 boost::multiprecision::denominator(value)) {}

EventScale::EventScale(const EventScale& other)
    : numerator_(other.numerator_), denominator_(other.denominator_) {
  if (is_long()) long_ = new Long(*other.long_);
}

Rational EventScale::exact() const { return {numerator(), denominator()}; }

Integer EventScale::numerator() const {
  return is_long() ? long_->numerator : to_integer(numerator_);
}

Integer EventScale::denominator() const {
  return is_long() ? long_->denominator : to_integer(denominator_);
}

double EventScale::rounded() const {
  if (is_long()) return long_->rounded;
  return static_cast<double>(numerator_) / static_cast<double>(denominator_);
}

int EventScale::sign() const {
  if (is_long()) return long_->numerator.sign();
  return numerator_ > 0 ? 1 : numerator_ < 0 ? -1 : 0;
}

int EventScale::compare(const EventScale& other) const {
  if (const double a = rounded(), b = other.rounded(); tell_the_order(a, b)) return a < b ? -1 : 1;
  if (is_long() || other.is_long()) {
    const int order =
        (numerator() * other.denominator()).compare(other.numerator() * denominator());
    return order > 0 ? 1 : order < 0 ? -1 : 0;
  }
  const int own_sign = sign(), other_sign = other.sign();
  if (own_sign != other_sign) return own_sign < other_sign ? -1 : 1;
  if (numerator_ == other.numerator_ && denominator_ == other.denominator_) return 0;
  const auto left = product(magnitude(numerator_), magnitude(other.denominator_)),
             right = product(magnitude(other.numerator_), magnitude(denominator_));
  if (left == right) return 0;
  return (left > right) == (own_sign > 0) ? 1 : -1;
}

}  // namespace minkref::inline space
