// Whether P and x - Q meet, by edges and triangles, against the cells of the sum.
#include "reference/space/edges/collision.hpp"

#include <gtest/gtest.h>

#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_collision {
namespace {

using bodies::for_each_seed;
using bodies::unit;
using polycubes::block;
using polycubes::Cells;
using polycubes::solid;
using polycubes::with;
using polycubes::without;

/// Cells so many times as wide.
Cells enlarged(const Cells& cells, int times) {
  Cells result;
  for (const auto& [x, y, z] : cells) {
    result.merge(block({times * x, times * y, times * z},
                       {times * (x + 1), times * (y + 1), times * (z + 1)}));
  }
  return result;
}

Cells moved(const Cells& cells, int by) {
  Cells result;
  for (const auto& [x, y, z] : cells) result.insert({x + by, y - by, z + by});
  return result;
}

/// Checks at cells' midpoints that the collision test, which does not know cells, finds the sum's
/// cells.
void expect_cells_of_sum(const Cells& a, const Cells& b, std::mt19937& dice) {
  const Scaling twice{2, 2, 2};
  const SpaceOperands operands =
      space_operands(scaled(solid(a), twice), scaled(solid(b), twice), unit);
  const CollisionTrees trees(operands.P, operands.Q, {});
  Collision collision(trees);
  const Cells sum = polycubes::sum_of_cells(a, b);
  polycubes::Cell low = *sum.begin(), high = low;
  for (const auto& cell : sum) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], cell[k] - 1);
      high[k] = std::max(high[k], cell[k] + 1);
    }
  }
  for (int round = 0; round < 150; ++round) {
    polycubes::Cell cell{};
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = std::uniform_int_distribution<int>(low[k], high[k])(dice);
    }
    const IntegerVector middle{2 * cell[0] + 1, 2 * cell[1] + 1, 2 * cell[2] + 1};
    const NudgedPoint x(FilteredVector(middle, 0).rounded, [&]() -> NudgedPoint::Exact {
      return {middle, Integer(1), {1, 2, -3}, {2, -1, 1}};
    });
    EXPECT_EQ(collision.contains(x), sum.contains(cell))
        << cell[0] << " " << cell[1] << " " << cell[2];
  }
}

/// An operand may contain the other operand, or a part, or have it inside its cavity.
TEST(Collision, TellsWhichCellsAreInTheSum) {
  const Cells hollow = without(block({0, 0, 0}, {4, 4, 4}), block({1, 1, 1}, {3, 3, 3}));
  for_each_seed(12, [&](std::mt19937& dice) {
    const Cells large = enlarged(polycubes::random_cells(dice, 5, 3), 4);
    const Cells parts = with(moved(polycubes::random_cells(dice, 3, 2), 11),
                             moved(polycubes::random_cells(dice, 2, 2), -9));
    for (const Cells& a : {large, enlarged(hollow, 2)}) {
      expect_cells_of_sum(a, parts, dice);
      expect_cells_of_sum(parts, a, dice);
      expect_cells_of_sum(with(moved(a, 1), moved(parts, 20)), parts, dice);
    }
  });
}

}  // namespace
}  // namespace minkref::of_collision
