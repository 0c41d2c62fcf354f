// Changes to a pair's scale and window.
#pragma once

#include "formats/case.hpp"
#include "tests/fuzzing/reference/dice.hpp"

namespace minkref::fuzzing {

/// The pair is valid.
void change_scale(Dice& dice, Case& pair);

/// Exchanges P and Q: sums equal the earlier sums divided by the scale.
void exchange_operands(Case& pair);

}  // namespace minkref::fuzzing
