// Scales as fractions of integers of any length, not reduced.
#pragma once

#include "reference/plane/kernel/grid_kernel.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

/// num / den, den > 0.
struct Fraction {
  Integer num = 0, den = 1;
};

inline Fraction fraction(const Rational& value) { return {numerator(value), denominator(value)}; }
inline Fraction fraction(const Rational& num, const Rational& den) { return fraction(num / den); }
template <class Wide>
Fraction fraction(const Wide& num, const Wide& den) {
  if (den < 0) return {-grid_integer(num), -grid_integer(den)};
  return {grid_integer(num), grid_integer(den)};
}
/// A grid kernel's parameter as a fraction.
template <class Parameter>
Fraction fraction(const Parameter& parameter) {
  return fraction(parameter.num, parameter.den);
}

/// The sign of slope s + value at s.
inline int sign_at(const Rational& slope, const Rational& value, const Fraction& s) {
  return sign(Rational(slope * Rational(s.num, s.den) + value));
}
template <class Wide>
int sign_at(const Wide& slope, const Wide& value, const Fraction& s) {
  return sign(Integer(grid_integer(slope) * s.num + grid_integer(value) * s.den));
}

}  // namespace minkref::inline plane
