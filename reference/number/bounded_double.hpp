// Doubles with a bound of their error: the filter before exact integers.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/number/rational.hpp"

namespace minkref {

/// A real number within `error` of `value`. An error of 0 means an exact integer of at most 53
/// bits: sums and products of exact integers stay exact up to this length, so a zero among small
/// integers is certain too. Infinite or NaN bounds, after overflow, decide nothing. Bounds hold
/// while a FloatEnvironment is held; without a FloatEnvironment, construction from an Integer
/// throws UnsafeFloats.
struct BoundedDouble {
  double value = 0, error = 0;

  BoundedDouble() = default;
  BoundedDouble(double value_, double error_) : value(value_), error(error_) {}
  /// Requires an integer of at most 53 bits.
  BoundedDouble(int integer) : value(integer) {}  // NOLINT: implicit, since it is exact
  /// integer * 2^-shift, shift >= 0.
  explicit BoundedDouble(const Integer& integer, long shift = 0) {
    FloatEnvironment::require();
    long exponent = 0;
    value = mpz_get_d_2exp(&exponent, integer.backend().data());
    exponent = std::clamp(exponent - shift, -longest_exponent, longest_exponent);
    value = std::ldexp(value, static_cast<int>(exponent));
    const bool exact = integer.is_zero() || (shift == 0 && std::abs(value) < most_exact);
    if (!exact) error = enlarged(std::abs(value) * 0x1p-52);
  }

  /// Returned by certain_sign for an uncertain sign.
  static constexpr int undecided = 2;
  int certain_sign() const {
    if (value > error) return 1;
    if (value < -error) return -1;
    return value == 0 && error == 0 ? 0 : undecided;
  }

  friend BoundedDouble operator-(const BoundedDouble& a) { return {-a.value, a.error}; }
  friend BoundedDouble operator+(const BoundedDouble& a, const BoundedDouble& b) {
    return rounded(a.value + b.value, a.error + b.error, both_exact(a, b));
  }
  friend BoundedDouble operator-(const BoundedDouble& a, const BoundedDouble& b) {
    return rounded(a.value - b.value, a.error + b.error, both_exact(a, b));
  }
  friend BoundedDouble operator*(const BoundedDouble& a, const BoundedDouble& b) {
    const double inherited =
        std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
    return rounded(a.value * b.value, inherited, both_exact(a, b));
  }
  /// Never exact. Unbounded if the divisor may be 0.
  friend BoundedDouble operator/(const BoundedDouble& a, const BoundedDouble& b) {
    const double divisor = std::abs(b.value) - b.error;
    if (!(divisor > 0)) return {0, std::numeric_limits<double>::infinity()};
    const double quotient = a.value / b.value;
    const double inherited = (a.error + std::abs(quotient) * b.error) / (divisor * (1 - 0x1p-50));
    return {quotient, enlarged(inherited + std::abs(quotient) * unit)};
  }

 private:
  static constexpr double most_exact = 0x1p53, unit = 0x1p-53;
  static constexpr long longest_exponent = 5000;

  /// The few roundings of the bound itself, and underflow.
  static double enlarged(double error) {
    return error * (1 + 0x1p-49) + std::numeric_limits<double>::min();
  }
  /// Looks at both errors, not at the inherited error: products of errors may underflow.
  static bool both_exact(const BoundedDouble& a, const BoundedDouble& b) {
    return a.error == 0 && b.error == 0;
  }
  static BoundedDouble rounded(double value, double inherited, bool exact) {
    const double magnitude = std::abs(value);
    if (exact && magnitude < most_exact) return {value, 0};
    return {value, enlarged(inherited + magnitude * unit)};
  }
};

}  // namespace minkref
