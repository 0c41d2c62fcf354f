// The sum at one scale, read off the swept boundary.
#pragma once

#include "reference/plane/index/swept_boundary.hpp"

namespace minkref::inline plane {

/// sP + Q in canonical form, without statistics and tight passages. The window of the boundary has
/// to hold the scale; at an event's the sum is the limit of those just below, and at the start of
/// the window of those just above. Exact. O(p + b log b) for p pieces in all and b at the scale.
Sum slice(const SweptBoundary& boundary, const Rational& scale);

}  // namespace minkref::inline plane
