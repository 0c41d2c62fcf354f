// A convex sum as pieces, some perhaps coplanar, and how the pieces become facets.
#pragma once

#include <algorithm>
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

/// The convex hull's corners for coplanar points, counter-clockwise seen against the normal.
template <class Point>
Face corners_of_hull(const std::vector<Point>& points, const AreaVector<Point>& normal,
                     Face among) {
  const std::size_t axis = longest_axis(normal);
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto same = [&](std::uint32_t a, std::uint32_t b) {
    return points[a][u] == points[b][u] && points[a][v] == points[b][v];
  };
  std::sort(among.begin(), among.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a][u] != points[b][u]) return points[a][u] < points[b][u];
    return points[a][v] < points[b][v];
  });
  among.erase(std::unique(among.begin(), among.end(), same), among.end());
  const auto turns_left = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return cross(points[b] - points[a], points[c] - points[a])[axis] > 0;
  };
  Face hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const std::uint32_t k : among) {
      while (hull.size() >= base + 2 && !turns_left(hull[hull.size() - 2], hull.back(), k)) {
        hull.pop_back();
      }
      hull.push_back(k);
    }
    hull.pop_back();
    std::reverse(among.begin(), among.end());
  }
  if (normal[axis] < 0) std::reverse(hull.begin(), hull.end());
  return hull;
}

/// The sum as canonical form, certified like surface_of. Exact. O(k log k).
ConvexSum united(const Pieces<WordVector>& pieces);
ConvexSum united(const Pieces<IntegerVector>& pieces);

}  // namespace minkref::inline space
