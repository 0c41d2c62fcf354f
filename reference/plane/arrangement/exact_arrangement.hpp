// The arrangement over the exact kernels, compiled once for each.
#pragma once

#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref::inline plane {

extern template class Arrangement<GridKernel<Grid64>>;
extern template class Arrangement<GridKernel<Grid256>>;
extern template class Arrangement<PlainKernel<Rational>>;

}  // namespace minkref::inline plane
