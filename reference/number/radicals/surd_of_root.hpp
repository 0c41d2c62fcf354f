// A number with nested roots as an expression that takes operands from any field.
#pragma once

#include "reference/number/radicals/root_number.hpp"
#include "reference/number/radicals/surd.hpp"

namespace minkref {

/// The same number. Its roots become roots of expressions; O(2^roots) operations.
Surd surd_of(const RootNumber& value);

}  // namespace minkref
