// The boundary at each event's scale, as far as it differs from the links that go on across it.
#pragma once

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/history/boundary_history.hpp"
#include "reference/plane/index/moving_boundary.hpp"

namespace minkref::inline plane {

/// Each piece is part of one link below the event and of one above, and lies on the lower link's
/// edge.
struct BoundaryAtEvent : BoundaryAtGroup {
  /// Segments that links from below, or from above, cover both ways: the closed sum covers them.
  /// Each once, given by its ends.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> folded;
  bool pinched = false;  ///< a point where something happens is passed more than once

  /// Whether the rings below, without sides of length zero, equal the rings at the scale.
  bool is_plain() const { return !pinched && folded.empty(); }
};

/// The boundary at each event. Exact. O(n log n) for n links, if few share a line at an event.
/// Throws std::logic_error unless the boundary from below equals the boundary from above: an
/// independent check of the swept boundary.
std::vector<BoundaryAtEvent> boundary_at_events(const MovingBoundary& boundary,
                                                const EdgeDirections& directions,
                                                const BuildControl& control);

}  // namespace minkref::inline plane
