// Edges where plane regions cross without any border.
#pragma once

#include <utility>
#include <vector>

#include "reference/space/surface/lifted_regions.hpp"

namespace minkref::inline space {

/// Finds segments inside two regions that cross there. Three regions, or any odd number, can cross
/// along a line, with interior and outside taking turns about it; each region goes straight on,
/// without a border there. (Two regions cannot do so: one half of each would have the set on the
/// other side.) Segments overlap if several pairs find them. Exact. O(n log n + m) for m pairs of
/// polygons with overlapping boxes, times the vertices of the smaller polygon; of both polygons, if
/// each has corners on both sides of the other.
std::vector<std::pair<SpaceVertex, SpaceVertex>> hidden_edges(const LiftedRegions& regions);

}  // namespace minkref::inline space
