// Where a point lies with respect to a ring or a set: by the crossings of a ray, exactly.
#pragma once

#include <vector>

#include "reference/plane/point_predicates.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

enum class Location { outside, boundary, inside };

/// A closed chain of points, ready to be asked many times.
using FilteredRing = std::vector<FilteredPoint>;
FilteredRing filtered_ring(const Ring& ring);

/// Exact. O(n).
Location locate(const FilteredRing& ring, const FilteredPoint& point);

/// Inside: the winding number with respect to all rings is positive. Exact. O(n).
Location locate(const PolygonSet& set, const Point& point);

}  // namespace minkref::inline plane
