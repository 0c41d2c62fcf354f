#include "reference/plane/exact_arrangement.hpp"

namespace minkref {

template class Arrangement<GridKernel<Grid64>>;

}  // namespace minkref
