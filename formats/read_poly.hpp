// Reader of `.poly`, the format of the paper's models.
#pragma once

#include <string_view>

#include "formats/set_builder.hpp"

namespace minkref {

/// `#` comments; the number of rings; for each ring a line with its count and `in` or `out`, one
/// vertex a line, then perhaps the indices 1...n in the ring's order. A hole belongs to the
/// smallest outer ring around it. Every ring has three vertices or more: points and segments have
/// no form here. Refuses everything else with its line.
void read_poly(std::string_view text, SetBuilder& set);

}  // namespace minkref
