// The corners of the rings of a bucket, each for the scales at which it is one.
#pragma once

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/index/ring_order.hpp"

namespace minkref::inline plane {

/// Of one ring, in ring order: at each interval those that are there are its corners, where the
/// direction changes; the link of each is the one that leaves it. O(n + changes times the entries
/// between neighbours).
void append_corners(const RingEntry* begin, const RingEntry* end, const MovingBoundary& boundary,
                    const EdgeDirections& directions, std::vector<RingEntry>& corners);

}  // namespace minkref::inline plane
