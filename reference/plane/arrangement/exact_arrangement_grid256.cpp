#include "reference/plane/arrangement/exact_arrangement.hpp"

namespace minkref {

template class Arrangement<GridKernel<Grid256>>;

}  // namespace minkref
