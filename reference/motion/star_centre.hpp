// Whether some point of a set sees the whole set.
#pragma once

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline motion {

/// Whether some point of the set sees every other along a segment inside the set. With such a point
/// at the origin, a smaller copy of the set lies inside a larger copy. Never true for a set without
/// star centre, but overlooks the centre of several touching polygons. Exact. O(n^2), for a convex
/// set O(n).
bool has_star_centre(const PolygonSet& set);

}  // namespace minkref::inline motion
