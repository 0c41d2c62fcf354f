// Points of a set that see the whole set.
#pragma once

#include <optional>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline motion {

/// A point that sees every other point of a set along a segment inside the set. `is_inside`: the
/// point lies strictly on the inner side of every edge, so that a larger copy of the set about this
/// point also holds all points near a smaller copy.
struct StarCentre {
  Point at;
  bool is_inside = false;
};

/// A star centre of a set; inside, if the set has such a centre. With the centre at the origin, a
/// smaller copy of the set lies inside a larger copy. Nothing for a set without star centre, nor
/// for several touching polygons. Exact. O(n^2), for a convex set O(n).
std::optional<StarCentre> star_centre(const PolygonSet& set);

/// Whether a point is a star centre strictly on the inner side of every edge. Exact. O(n).
bool is_inner_star_centre(const PolygonSet& set, const Point& at);

}  // namespace minkref::inline motion
