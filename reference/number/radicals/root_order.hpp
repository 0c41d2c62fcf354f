// The order of numbers of different fields.
#pragma once

#include "reference/number/radicals/root_number.hpp"

namespace minkref {

/// The sign of a - b. Exact: doubles and MPFR where they tell; else both are equal iff both are
/// roots of the common divisor of their polynomials and only one of its roots is where they are
/// (Sturm). Ends, since numbers that differ are told apart by enough bits.
int compare(const RootNumber& a, const RootNumber& b);

}  // namespace minkref
