// The corners of the rings of a bucket, each for the scales at which it is one.
#pragma once

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/index/ring_order.hpp"

namespace minkref::inline plane {

/// Appends the corners of one ring, in ring order: the entries there at an interval are the ring's
/// corners, where the direction changes; the link of an entry leaves its corner. O(n + changes
/// times the entries between neighbours).
void append_corners(const RingEntry* begin, const RingEntry* end, const MovingBoundary& boundary,
                    const EdgeDirections& directions, std::vector<RingEntry>& corners);

}  // namespace minkref::inline plane
