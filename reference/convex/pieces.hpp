// A convex sum as pieces that may lie in one plane, and how they become facets.
#pragma once

#include <vector>

#include "reference/convex/convex_sum.hpp"
#include "reference/space/integer_points.hpp"

namespace minkref {

/// Convex pieces that tile the boundary of a sum. Points are over one denominator for each axis:
/// planes stay planes, and convex is convex.
struct Pieces {
  std::vector<SumVertices::Pair> pairs;
  std::vector<IntegerVector> points;  ///< of the pairs
  IntegerVector denominators{1, 1, 1};
  std::vector<Face> rings;  ///< of pairs, counter-clockwise seen from outside
  std::vector<IntegerVector> normals;

  /// A ring without area, of two parallel edges, lies in an edge of the sum and is left out.
  void add(Face ring);
};

/// The sum in canonical form, certified as surface_of is. Exact. O(k log k).
ConvexSum united(const Pieces& pieces);

}  // namespace minkref
