// The sum at one scale, read off the swept boundary.
#pragma once

#include "reference/plane/dynamic/node_track.hpp"
#include "reference/scalespace/swept_boundary.hpp"

namespace minkref {

/// Where a node of a piece is, as a function of the scale. Exact.
Track track_of(const SweptBoundary& boundary, std::uint32_t edge, const NodeName& node);

/// sP + Q in canonical form, without statistics and tight passages. The window of the boundary has
/// to hold the scale; at an event's the sum is the limit of those just below, and at the start of
/// the window of those just above. Exact. O(p + b log b) for p pieces in all and b at the scale.
Sum slice(const SweptBoundary& boundary, const Rational& scale);

}  // namespace minkref
