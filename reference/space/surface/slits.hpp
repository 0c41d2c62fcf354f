// Edges and points that lie in the inside of plane regions.
#pragma once

#include <vector>

#include "reference/space/surface/conforming_edges.hpp"
#include "reference/space/surface/lifted_regions.hpp"

namespace minkref::inline space {

/// Sets `slits` and `tips` of edges that have all else. Exact. std::logic_error where a segment
/// crosses the border of a region.
void add_slits_and_tips(const LiftedRegions& regions, ConformingEdges& edges);

}  // namespace minkref::inline space
