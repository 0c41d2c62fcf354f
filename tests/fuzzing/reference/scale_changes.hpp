// Changes of the scale of a pair and of its window.
#pragma once

#include "formats/case.hpp"
#include "tests/fuzzing/reference/dice.hpp"

namespace minkref::fuzzing {

/// The pair is valid.
void change_scale(Dice& dice, Case& pair);

/// P and Q exchanged: sums are those from before, divided by the scale.
void exchange_operands(Case& pair);

}  // namespace minkref::fuzzing
