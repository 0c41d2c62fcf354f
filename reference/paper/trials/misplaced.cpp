#include "reference/paper/trials/misplaced.hpp"

#include <cstdlib>

namespace minkref {

Rational ulp(const Rational& value, long bits) {
  const Integer num = numerator(value), den = denominator(value);
  long e = static_cast<long>(msb(num)) - static_cast<long>(msb(den));
  const auto power = [](long exponent) {
    const Integer two = Integer(1) << static_cast<unsigned long>(std::abs(exponent));
    return exponent < 0 ? Rational(Integer(1), two) : Rational(two);
  };
  if (value < power(e)) --e;
  return power(e - bits + 1);
}

}  // namespace minkref
