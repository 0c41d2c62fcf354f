#pragma once

#include "reference/number/mpfr.hpp"
#include "reference/number/rational.hpp"

namespace minkref {

/// The exact value of a rounded number.
inline Rational exact_value(double value) { return from_double(value); }
inline Rational exact_value(const Mpfr& value) { return exact(value); }

}  // namespace minkref
