#pragma once

#include "reference/number/interval.hpp"
#include "reference/number/mpfr.hpp"
#include "reference/number/rational.hpp"

namespace minkref {

/// The exact value of a number; of an interval, the middle as a double.
inline Rational exact_value(const Rational& value) { return value; }
inline Rational exact_value(const Interval& value) { return from_double(approximate(value)); }
inline Rational exact_value(double value) { return from_double(value); }
inline Rational exact_value(const Mpfr& value) { return exact(value); }

}  // namespace minkref
