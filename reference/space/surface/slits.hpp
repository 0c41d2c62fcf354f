// Edges and points inside plane regions.
#pragma once

#include <vector>

#include "reference/space/surface/conforming_edges.hpp"
#include "reference/space/surface/lifted_regions.hpp"

namespace minkref::inline space {

/// Sets `slits` and `tips` for otherwise complete edges. Exact. Throws std::logic_error if a
/// segment crosses a region's border.
void add_slits_and_tips(const LiftedRegions& regions, ConformingEdges& edges);

}  // namespace minkref::inline space
