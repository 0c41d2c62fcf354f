// Whether a point of a set sees all of it.
#pragma once

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline paths {

/// Whether the set has a point to which the segment from each of its points lies in the set. Moved
/// so that this point is the origin, a smaller one lies in a larger one. Never says so of a set
/// that has none; of several polygons that touch it does not find it. Exact. O(n^2), for a convex
/// set O(n).
bool has_star_centre(const PolygonSet& set);

}  // namespace minkref::inline paths
