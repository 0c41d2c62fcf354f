#include "reference/plane/arrangement/exact_arrangement.hpp"

namespace minkref {

template class Arrangement<PlainKernel<Rational>>;

}  // namespace minkref
