// The boundary of the sum as links between tracks, each for a stretch of scales.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/plane/history/boundary_history.hpp"
#include "reference/plane/index/swept_boundary.hpp"

namespace minkref::inline plane {

/// Two tracks that meet at the scale of an event, and go apart again.
struct TrackContact {
  std::uint32_t event = 0;
  std::uint32_t a = 0, b = 0;
};

/// Interval 0 goes from the start of the window to the first event, interval k from event k - 1 on.
struct MovingBoundary {
  /// Scales inside the window at which a link begins or ends, or two tracks touch.
  std::vector<Rational> events;
  std::vector<Track> tracks;      ///< no two are the same
  std::vector<MovingLink> links;  ///< of the boundary; between two tracks never two at a scale
  /// Exposed pieces that face each other: both directions at once. The closed sum covers them.
  std::vector<MovingLink> passages;
  std::vector<TrackContact> contacts;  ///< sorted by event
  std::uint64_t pieces = 0;            ///< exposed ones, joined where nothing divides them
};

/// Exact. The same for all swept boundaries of a pair of operands, whatever crossings inside the
/// sum cut their pieces. O(p log p) for p pieces.
MovingBoundary moving_boundary(const SweptBoundary& boundary, const BuildControl& control);

}  // namespace minkref::inline plane
