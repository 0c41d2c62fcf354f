#include "reference/plane/arrangement/exact_arrangement.hpp"

namespace minkref::inline plane {

template class Arrangement<GridKernel<Grid256>>;

}  // namespace minkref::inline plane
