// Polynomials with rational coefficients, the lowest first, without zeros at the end.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/number/rational.hpp"

namespace minkref {

using Polynomial = std::vector<Rational>;

/// The common divisor, monic; empty if both are zero. Euclid.
Polynomial common_divisor(Polynomial a, Polynomial b);

/// The same roots, each once; monic.
Polynomial without_multiple_roots(const Polynomial& p);

/// The count of different real roots in (low, high], by Sturm's theorem.
std::size_t count_roots(const Polynomial& p, const Rational& low, const Rational& high);

template <class Number>
Number value_at(const Polynomial& p, const Number& x) {
  Number value(Rational(0));
  for (std::size_t k = p.size(); k-- > 0;) value = value * x + Number(p[k]);
  return value;
}

}  // namespace minkref
