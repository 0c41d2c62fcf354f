#include "reference/plane/arrangement/exact_arrangement.hpp"

namespace minkref::inline plane {

template class Arrangement<PlainKernel<Rational>>;

}  // namespace minkref::inline plane
