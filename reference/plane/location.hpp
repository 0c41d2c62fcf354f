// A point's location relative to a ring or a set: by the crossings of a ray, exactly.
#pragma once

#include <vector>

#include "reference/plane/point_predicates.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

enum class Location { outside, boundary, inside };

/// A closed chain of points, ready to be asked many times.
using FilteredRing = std::vector<FilteredPoint>;
FilteredRing filtered_ring(const Ring& ring);

/// Adds the winding of the edge from a to b around a point: nothing for an edge wholly left of the
/// point. Returns whether the point lies on the edge. Exact. O(1).
bool add_winding(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& point,
                 int& winding);

/// Exact. O(n).
Location locate(const FilteredRing& ring, const FilteredPoint& point);

/// Inside: the winding number with respect to all rings is positive. Exact. O(n).
Location locate(const PolygonSet& set, const Point& point);

}  // namespace minkref::inline plane
