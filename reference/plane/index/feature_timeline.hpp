// Holes and components through a moving boundary's scales, and the features that each ring bounds.
#pragma once

#include "reference/plane/history/topology_timeline.hpp"
#include "reference/plane/index/link_history.hpp"

namespace minkref::inline plane {

/// Gives the rings of all buckets their features; splits a bucket when a continuing ring gets other
/// features. The result's groups are events. Exact. O(b) for each event that is not quiet and a
/// boundary of b links.
TopologyTimeline feature_timeline(const SweptBoundary& swept, const MovingBoundary& boundary,
                                  const EdgeDirections& directions,
                                  const std::vector<BoundaryAtEvent>& at_events, RingOrder& order,
                                  const BuildControl& control);

}  // namespace minkref::inline plane
