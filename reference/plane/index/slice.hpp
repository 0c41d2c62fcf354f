// The sum at one scale, read off the swept boundary.
#pragma once

#include "reference/plane/index/swept_boundary.hpp"

namespace minkref::inline plane {

/// sP + Q in canonical form, without statistics and tight passages. The boundary's window has to
/// hold the scale; at an event the sum is the limit of sums just below, and at the window's start
/// the limit of sums just above. Exact. O(p + b log b) for p pieces overall and b at the scale.
Sum slice(const SweptBoundary& boundary, const Rational& scale);

}  // namespace minkref::inline plane
