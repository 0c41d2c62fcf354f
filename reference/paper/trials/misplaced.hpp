// Whether an answer in some arithmetic is more than an ulp from the truth.
#pragma once

#include "reference/number/exact_value.hpp"
#include "reference/number/scalar.hpp"

namespace minkref {

/// 2^e: the distance of neighbours among numbers of `bits` bits at this positive value.
Rational ulp(const Rational& value, long bits);

inline long precision(const Arithmetic<Mpfr>& arithmetic) { return arithmetic.precision(); }
template <class T>
long precision(const Arithmetic<T>&) {
  return 53;
}

inline bool misplaced(const Rational& truth, const Rational& got, long) { return truth != got; }
/// An interval counts as misplaced if it does not hold the truth.
inline bool misplaced(const Rational& truth, const Interval& got, long) {
  const Enclosure e = enclose(truth);
  return got.lower() > e.lower || got.upper() < e.upper;
}
template <class T>
bool misplaced(const Rational& truth, const T& got, long bits) {
  const Rational off(exact_value(got) - truth);
  return abs(off) > ulp(truth, bits);
}

}  // namespace minkref
