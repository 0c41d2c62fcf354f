// Edges where plane regions cross: no border of any of them.
#pragma once

#include <utility>
#include <vector>

#include "reference/space/surface/lifted_regions.hpp"

namespace minkref::inline space {

/// Segments that lie in the inside of two regions that cross there. Three regions, or any odd
/// number, can cross in a line, interior and outside in turn about it; each of them goes straight
/// on, and none has a border there. (The same with two regions is not possible: one half of each
/// would have the set on the other side.) Segments overlap where several pairs find them. Exact.
/// O(n log n + m) for m pairs of polygons whose boxes overlap, times the vertices of the smaller
/// one; of both, where each has corners on both sides of the other.
std::vector<std::pair<SpaceVertex, SpaceVertex>> hidden_edges(const LiftedRegions& regions);

}  // namespace minkref::inline space
