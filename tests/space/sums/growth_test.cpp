// Sums of flat faces with many corners: pieces and signs are counted, no time.
#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/space/edges/edge_sum.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::of_growth_of_sums_in_space {
namespace {

/// A comb with a thickness, whose teeth stand closer than a side of the box below.
Polyhedron comb_prism(int teeth) {
  std::vector<std::pair<int, int>> ring{{-20, -100}, {20 * teeth, -100}};
  for (int k = teeth - 1; k >= 0; --k) {
    for (const auto& [x, y] : {std::pair(9, 0), {9, 400}, {0, 400}, {0, 0}}) {
      ring.emplace_back(20 * k + x, y);
    }
  }
  Polyhedron result;
  const auto count = static_cast<std::uint32_t>(ring.size());
  for (const int z : {0, 50}) {
    for (const auto& [x, y] : ring) result.vertices.push_back(bodies::at(x, y, z));
  }
  Face below, above;
  for (std::uint32_t k = 0; k < count; ++k) {
    below.push_back(count - 1 - k);
    above.push_back(count + k);
    const std::uint32_t next = (k + 1) % count;
    result.faces.push_back({k, next, count + next, count + k});
  }
  result.faces.push_back(below);
  result.faces.push_back(above);
  return result;
}

EdgeSum sum_with_a_box(int teeth) {
  return edge_sum(comb_prism(teeth), bodies::box(100, 100, 100), bodies::unit);
}

/// The diagonals of the comb's two caps cross all facets about them, and bear no edge.
TEST(GrowthOfSumsInSpace, DiagonalsOfAFlatFaceAreNotCut) {
  const EdgeSum sum = sum_with_a_box(24);
  EXPECT_EQ(sum.set.faces.size(), 10U);
  EXPECT_LT(sum.statistics.pieces, 2600U) << "of " << sum.facets << " facets";
}

/// A point over a flat face is held against none of the facets in the face's own plane.
TEST(GrowthOfSumsInSpace, PointsOverAFlatFaceTakeFewExactSigns) {
  const EdgeSum sum = sum_with_a_box(24);
  EXPECT_EQ(sum.statistics.tests, 230U);
  EXPECT_LT(sum.statistics.signs.by_integer, 80000U);
}

}  // namespace
}  // namespace minkref::of_growth_of_sums_in_space
