// A polygon set as convex pieces whose interiors cover the interior as far as needed.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline motion {

/// Corners counter-clockwise, straight ones allowed; two for a segment, a single corner for a
/// point.
using ConvexCorners = std::vector<Point>;

/// Convex polygons whose union is the set. `open`: each interior point lies inside some piece, also
/// where pieces meet; needed beside a point or a segment, which may lie along the seam of two.
/// Otherwise seams do no harm: interiors that meet share an area. Exact. O(n^2).
std::vector<ConvexCorners> open_pieces(const PolygonSet& set, bool open);

}  // namespace minkref::inline motion
