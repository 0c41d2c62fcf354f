#include "reference/number/error_free.hpp"

namespace minkref::error_free::scaled {

// Both scale the operands to [1/2, 1) by powers of two (exact), and the rounded result to the same
// scale (exact too, since a subnormal result is scaled up). One fma then cannot underflow.

double product_residual(double a, double b, double product) {
  int a_exponent = 0, b_exponent = 0;
  const double a_part = std::frexp(a, &a_exponent), b_part = std::frexp(b, &b_exponent);
  return std::fma(a_part, b_part, -std::ldexp(product, -(a_exponent + b_exponent)));
}

double quotient_residual(double a, double b, double quotient) {
  int a_exponent = 0, b_exponent = 0;
  const double a_part = std::frexp(a, &a_exponent), b_part = std::frexp(b, &b_exponent);
  const double remainder = std::fma(-std::ldexp(quotient, b_exponent - a_exponent), b_part, a_part);
  return b > 0 ? remainder : -remainder;
}

}  // namespace minkref::error_free::scaled
