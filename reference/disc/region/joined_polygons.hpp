// The polygons of P that share a component of the interior of P ⊕ ρD.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// By polygon, the same number for all polygons of one component. Two polygons share a component if
/// they are nearer to each other than twice the radius, or exactly as near along facing edges.
/// Exact.
std::vector<std::uint32_t> joined_polygons(const PatchesAt& at, std::size_t polygons);

}  // namespace minkref::inline disc
