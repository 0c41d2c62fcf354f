// Which polygons of P are in one component of the interior of P ⊕ ρD.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// By polygon, the same number for those in one component. Two that are nearer to each other than
/// twice the radius are in one, and two that are as near along facing edges. Exact.
std::vector<std::uint32_t> joined_polygons(const PatchesAt& at, std::size_t polygons);

}  // namespace minkref::inline disc
