#include "reference/plane/arrangement/exact_arrangement.hpp"

namespace minkref {

template class Arrangement<GridKernel<Grid64>>;

}  // namespace minkref
