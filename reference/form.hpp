// Which form of a formula of the paper is meant, where the printed one does not hold.
#pragma once

namespace minkref {

/// docs/definitions.md, "Printed and corrected".
enum class Form { corrected, printed };

}  // namespace minkref
