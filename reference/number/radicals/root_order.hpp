// The order of numbers from different fields.
#pragma once

#include "reference/number/radicals/root_number.hpp"

namespace minkref {

/// The sign of a - b. Exact: by doubles and MPFR if they tell; else a and b are equal iff both are
/// roots of the common divisor of their polynomials, and this has only one root near them (Sturm).
/// Ends, since enough bits tell different numbers apart.
int compare(const RootNumber& a, const RootNumber& b);

}  // namespace minkref
