// Polygon sets cut along slits into weakly simple rings, and their triangulation.
#pragma once

#include <array>
#include <vector>

#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The set with its holes joined to their outer rings by slits between vertices: one weakly simple
/// ring for each connected component of the interior, in `outer`, and no holes. Every vertex of the
/// result is one of the set. The interior less the slits is simply connected. Points and segments
/// are returned as they are. Exact. O(h n + n log n).
PolygonSet cut_to_simply_connected(const PolygonSet& set);

using Triangle = std::array<Point, 3>;

/// A triangulation of the set by diagonals between vertices, counter-clockwise triangles. Throws
/// std::logic_error if the areas do not add up (never seen). Exact. O(n^2).
std::vector<Triangle> triangulate(const PolygonSet& set);

}  // namespace minkref::inline plane
