// The boundary at the scale of each event, where it differs from what goes on across it.
#pragma once

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/history/boundary_history.hpp"
#include "reference/plane/index/moving_boundary.hpp"

namespace minkref::inline plane {

/// Its pieces are each part of one link below the event, and of one above; on the edge of the
/// former.
struct BoundaryAtEvent : BoundaryAtGroup {
  /// Segments that links from below, or from above, cover in both directions: the closed sum covers
  /// them. Each once, by its ends.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> folded;
  bool pinched = false;  ///< a point where something happens is passed more than once

  /// Whether the rings below, without sides of no length, are those at the scale.
  bool is_plain() const { return !pinched && folded.empty(); }
};

/// The boundary at each event. Exact. O(n log n) for n links, where few of them are on one line at
/// an event. Throws std::logic_error if the boundary left from below is not the boundary left from
/// above: a check of the swept boundary by itself.
std::vector<BoundaryAtEvent> boundary_at_events(const MovingBoundary& boundary,
                                                const EdgeDirections& directions,
                                                const BuildControl& control);

}  // namespace minkref::inline plane
