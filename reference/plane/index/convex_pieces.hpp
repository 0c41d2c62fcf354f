// Large convex polygons within a region, in doubles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// Counter-clockwise, with turns that doubles are sure of.
struct ConvexPiece {
  std::vector<std::array<double, 2>> corners;

  double area() const;
  /// The greatest product of a corner with a vector.
  double reach(double x, double y) const;
};

/// Polygons that certainly lie in the interior of the region, and may overlap: from the middle of a
/// triangle of a triangulation each grows as far as the edges of the region let it. First come
/// polygons whose middle is in no earlier polygon, large triangles before small ones, then polygons
/// of triangles that stick out of all. Parts thinner than some 2^-20 of the region are in none.
/// O(n^2 + n log n pieces).
std::vector<ConvexPiece> convex_pieces(const PolygonSet& region, std::size_t most_corners,
                                       std::size_t most_pieces);

}  // namespace minkref::inline plane
