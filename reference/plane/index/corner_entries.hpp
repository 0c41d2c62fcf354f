// The corners of a bucket's rings, each with its scales.
#pragma once

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/index/ring_order.hpp"

namespace minkref::inline plane {

/// Appends one ring's corners, in ring order: the entries of an interval are the ring's corners,
/// where the direction changes; an entry's link leaves its corner. O(n + changes times the entries
/// between neighbours).
void append_corners(const RingEntry* begin, const RingEntry* end, const MovingBoundary& boundary,
                    const EdgeDirections& directions, std::vector<RingEntry>& corners);

}  // namespace minkref::inline plane
