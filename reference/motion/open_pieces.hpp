// A polygon set as convex pieces, the interiors of which cover what they have to.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline paths {

/// Corners counter-clockwise, perhaps with straight ones; of a segment two, of a point one.
using ConvexCorners = std::vector<Point>;

/// Convex polygons whose union is the set. `open`: each point of the interior lies in the interior
/// of a piece, also where pieces meet; needed beside a point or a segment, which may lie along the
/// seam of two. Otherwise seams do no harm: interiors that meet share an area. Exact. O(n^2).
std::vector<ConvexCorners> open_pieces(const PolygonSet& set, bool open);

}  // namespace minkref::inline paths
