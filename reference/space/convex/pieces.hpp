// A convex sum as pieces that may lie in one plane, and how they become facets.
#pragma once

#include <utility>
#include <vector>

#include "reference/space/area_vector.hpp"
#include "reference/space/convex/convex_sum.hpp"

namespace minkref::inline space {

/// Convex pieces that tile the boundary of a sum. Points, WordVector or IntegerVector, are over one
/// denominator for each axis: planes stay planes, and convex is convex.
template <class Point>
struct Pieces {
  std::vector<SumVertices::Pair> pairs;
  std::vector<Point> points;  ///< of the pairs
  IntegerVector denominators{1, 1, 1};
  std::vector<Face> rings;  ///< of pairs, counter-clockwise seen from outside
  std::vector<AreaVector<Point>> normals;

  /// A ring without area, of two parallel edges, lies in an edge of the sum and is left out.
  void add(Face ring) {
    const auto normal = area_vector(points, ring);
    if (is_zero(normal)) return;
    normals.push_back(normal);
    rings.push_back(std::move(ring));
  }
};

/// The sum in canonical form, certified as surface_of is. Exact. O(k log k).
ConvexSum united(const Pieces<WordVector>& pieces);
ConvexSum united(const Pieces<IntegerVector>& pieces);

}  // namespace minkref::inline space
