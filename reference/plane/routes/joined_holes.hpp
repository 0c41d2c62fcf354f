// A component's holes joined to its outer walk.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {

/// Walks once around a connected region: along the outer walk, with a slit between two vertices to
/// each hole and back (Eberly, "Triangulation by ear clipping"). Walks hold point numbers
/// (boundary_walks); a hole may be a single point. Exact. O(n log n + k) for k edge boxes across
/// rays to the right or the triangles beside, few in usual input.
std::vector<std::uint32_t> joined_holes(const std::vector<FilteredPoint>& points,
                                        const std::vector<std::uint32_t>& outer,
                                        const std::vector<std::vector<std::uint32_t>>& holes);

}  // namespace minkref::inline plane
