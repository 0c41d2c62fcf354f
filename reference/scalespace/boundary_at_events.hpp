// The boundary at the scale of each event, where it differs from what goes on across it.
#pragma once

#include "reference/scalespace/edge_directions.hpp"
#include "reference/scalespace/moving_boundary.hpp"

namespace minkref {

/// A piece of the boundary at the scale of an event: part of one link below it, and of one above.
struct PieceAtEvent {
  std::uint32_t from = 0, to = 0;  ///< tracks that stand for their points
  std::uint32_t edge = 0;          ///< of the link below
  std::uint32_t before = 0, after = 0;
};

struct BoundaryAtEvent {
  /// Tracks that are at one point, each with the least of them, which stands for it; sorted. Those
  /// that stand for themselves are left out.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> merged;
  std::vector<PieceAtEvent> pieces;  ///< of links that end or begin
  /// Segments that links from below, or from above, cover in both directions: the closed sum covers
  /// them. Each once, by its ends.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> folded;
  bool pinched = false;  ///< a point where something happens is passed more than once

  std::uint32_t standing_for(std::uint32_t track) const;
  /// Whether the rings below, without sides of no length, are those at the scale.
  bool is_plain() const { return !pinched && folded.empty(); }
};

/// Of each event. Exact. O(n log n) for n links, where few of them are on one line at an event.
/// Throws std::logic_error if what is left of the boundary from below is not what is left from
/// above: a check of the swept boundary by itself.
std::vector<BoundaryAtEvent> boundary_at_events(const MovingBoundary& boundary,
                                                const EdgeDirections& directions);

}  // namespace minkref
