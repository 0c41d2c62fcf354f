// Large convex polygons within a region, in doubles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// Counter-clockwise, with turns beyond the doubt of doubles.
struct ConvexPiece {
  std::vector<std::array<double, 2>> corners;

  double area() const;
  /// The greatest product of a corner with a vector.
  double reach(double x, double y) const;
};

/// Polygons that certainly lie inside the region's interior, and may overlap: from the middle of a
/// triangle of a triangulation each grows up to the region's edges. First come polygons whose
/// middle lies outside all earlier polygons, large triangles before small triangles, then polygons
/// of triangles that stick out of all. Polygons leave out parts thinner than some 2^-20 of the
/// region. O(n^2 + n log n pieces).
std::vector<ConvexPiece> convex_pieces(const PolygonSet& region, std::size_t most_corners,
                                       std::size_t most_pieces);

}  // namespace minkref::inline plane
