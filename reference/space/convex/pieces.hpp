// A convex sum as pieces, some perhaps coplanar, and how the pieces become facets.
#pragma once

#include <utility>
#include <vector>

#include "reference/space/area_vector.hpp"
#include "reference/space/convex/convex_sum.hpp"

namespace minkref::inline space {

/// Convex pieces that tile a sum's boundary. Points, WordVector or IntegerVector, have one
/// denominator for each axis: planes stay planes, and convex pieces stay convex.
template <class Point>
struct Pieces {
  std::vector<SumVertices::Pair> pairs;
  std::vector<Point> points;  ///< of the pairs
  IntegerVector denominators{1, 1, 1};
  std::vector<Face> rings;  ///< of pairs, counter-clockwise seen from outside
  std::vector<AreaVector<Point>> normals;

  /// Adds a ring; a ring without area, between parallel edges, lies along an edge of the sum and
  /// adds nothing.
  void add(Face ring) {
    const auto normal = area_vector(points, ring);
    if (is_zero(normal)) return;
    normals.push_back(normal);
    rings.push_back(std::move(ring));
  }
};

/// The sum as canonical form, certified like surface_of. Exact. O(k log k).
ConvexSum united(const Pieces<WordVector>& pieces);
ConvexSum united(const Pieces<IntegerVector>& pieces);

}  // namespace minkref::inline space
