// Error-free transforms: the side of a rounded sum, product or quotient on which the exact result
// lies.
//
// Doubles are IEEE 754 binary64, rounded to nearest; the rounding mode is never changed. Each
// `*_residual` returns a double with the sign of (exact result - rounded result), zero iff the
// operation was exact; operands and result must be finite. Sources: Knuth (TwoSum), Dekker 1971
// (TwoProduct), Boldo, Graillat & Muller 2017 (overflow in TwoSum).
#pragma once

#include <cmath>

#include "reference/number/float_flags.hpp"

namespace minkref::error_free {

/// sum = fl(a + b). Exact for all finite operands, subnormal ones too.
inline double sum_residual(double a, double b, double sum) {
  if (std::abs(sum) < 0x1p1021) {  // then no step of TwoSum overflows
    const double b_part = sum - a;
    const double a_part = sum - b_part;
    return (a - a_part) + (b - b_part);
  }
  // After ordering by magnitude the shorter transform does; it overflows only where `sum` did.
  return std::abs(a) < std::abs(b) ? a - (sum - b) : b - (sum - a);
}

namespace scaled {  // for operands or results near the ends of the range; slow
double product_residual(double a, double b, double product);
double quotient_residual(double a, double b, double quotient);
}  // namespace scaled

/// a b - product where no part over- or underflows: |product| > 2^-960, |a|, |b|, |product| <
/// 2^990.
inline double plain_product_residual(double a, double b, double product) {
#if MINKREF_FAST_FMA
  return std::fma(a, b, -product);
#else
  constexpr double splitter = 0x1p27 + 1;
  const double a_scaled = splitter * a, b_scaled = splitter * b;
  const double a_high = a_scaled - (a_scaled - a), b_high = b_scaled - (b_scaled - b);
  const double a_low = a - a_high, b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
#endif
}

/// product = fl(a b), neither factor zero.
inline double product_residual(double a, double b, double product) {
  const double size = std::abs(product);
  if (size > 0x1p-960 && size < 0x1p990 && std::abs(a) < 0x1p990 && std::abs(b) < 0x1p990) {
    return plain_product_residual(a, b, product);
  }
  return scaled::product_residual(a, b, product);
}

/// quotient = fl(a / b), neither a nor b zero.
inline double quotient_residual(double a, double b, double quotient) {
  const double size = std::abs(a), ratio = std::abs(quotient), divisor = std::abs(b);
  if (size > 0x1p-960 && size < 0x1p980 && ratio > 0x1p-990 && ratio < 0x1p980 &&
      divisor > 0x1p-990 && divisor < 0x1p980) {
#if MINKREF_FAST_FMA
    const double remainder = std::fma(-quotient, b, a);
#else
    const double product = quotient * b;  // within a factor of two of a: a - product is exact
    const double remainder = (a - product) - plain_product_residual(quotient, b, product);
#endif
    return b > 0 ? remainder : -remainder;
  }
  return scaled::quotient_residual(a, b, quotient);
}

}  // namespace minkref::error_free
