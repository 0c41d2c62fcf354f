// Holes and components through the scales of a moving boundary, and which of them each ring bounds.
#pragma once

#include "reference/plane/history/topology_timeline.hpp"
#include "reference/plane/index/link_history.hpp"

namespace minkref::inline plane {

/// Gives the rings of all buckets their features; a bucket is cut in two where a ring that goes on
/// comes to bound something else. Groups of the result are events. Exact. O(b) for each event that
/// is not quiet and a boundary of b links.
TopologyTimeline feature_timeline(const SweptBoundary& swept, const MovingBoundary& boundary,
                                  const EdgeDirections& directions,
                                  const std::vector<BoundaryAtEvent>& at_events, RingOrder& order,
                                  const BuildControl& control);

}  // namespace minkref::inline plane
