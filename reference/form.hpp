// The form of a paper's formula that is meant, if the printed form does not hold.
#pragma once

namespace minkref {

/// docs/definitions.md, "Printed and corrected".
enum class Form { corrected, printed };

}  // namespace minkref
