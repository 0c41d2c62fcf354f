// Points covered by grid cells lie in the sum's interior.
#include "reference/space/edges/interior_cells.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference/space/edges/cell_grid.hpp"
#include "reference/space/edges/collision.hpp"
#include "reference/space/edges/edge_sum.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_interior_cells {
namespace {

using bodies::for_each_seed;
using bodies::unit;
using polycubes::block;
using polycubes::Cells;
using polycubes::solid;
using polycubes::without;
using Cell = CellGrid::Cell;

int number(std::mt19937& dice, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(dice);
}

std::set<Cell> cells_of(const CellGrid& grid) {
  std::set<Cell> cells;
  const auto &low = grid.low(), &size = grid.size();
  for (long z = low[2]; z < low[2] + size[2]; ++z) {
    for (long y = low[1]; y < low[1] + size[1]; ++y) {
      for (long x = low[0]; x < low[0] + size[0]; ++x) {
        if (grid.has({x, y, z})) cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

CellGrid random_grid(std::mt19937& dice) {
  const Cell low{number(dice, -90, 90), number(dice, -3, 3), number(dice, -3, 3)};
  const Cell size{number(dice, 1, 150), number(dice, 1, 4), number(dice, 1, 4)};
  CellGrid grid(low, size);
  const int full = number(dice, 1, 9);
  for (long z = 0; z < size[2]; ++z) {
    for (long y = 0; y < size[1]; ++y) {
      for (long x = 0; x < size[0]; ++x) {
        if (number(dice, 0, 9) < full) grid.add({low[0] + x, low[1] + y, low[2] + z});
      }
    }
  }
  return grid;
}

TEST(CellGrid, SumsAreThoseOfAllPairs) {
  for_each_seed(40, [&](std::mt19937& dice) {
    const CellGrid A = random_grid(dice), B = random_grid(dice);
    Cell low, size;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = A.low()[k] + B.low()[k];
      size[k] = A.size()[k] + B.size()[k];
    }
    CellGrid sum(low, size);
    add_sums(sum, A, B, {1, 0, 1});
    std::set<Cell> expected;
    for (const Cell& a : cells_of(A)) {
      for (const Cell& b : cells_of(B)) {
        expected.insert({a[0] + b[0] + 1, a[1] + b[1], a[2] + b[2] + 1});
      }
    }
    EXPECT_EQ(cells_of(sum), expected);
  });
}

TEST(CellGrid, CubesOfTwoHaveEightCells) {
  for_each_seed(40, [&](std::mt19937& dice) {
    const CellGrid grid = random_grid(dice);
    const std::set<Cell> cells = cells_of(grid);
    std::set<Cell> expected;
    for (const Cell& c : cells) {
      bool all = true;
      for (int k = 1; k < 8; ++k) {
        all = all && cells.count({c[0] + (k & 1), c[1] + (k >> 1 & 1), c[2] + (k >> 2)}) == 1;
      }
      if (all) expected.insert(c);
    }
    EXPECT_EQ(cells_of(cubes_of_two(grid)), expected);
  });
}

/// Whether leaving the point in any direction stays inside the sum.
bool is_interior(Collision& collision, const IntegerVector& point) {
  for (int k = 0; k < 8; ++k) {
    const IntegerVector along{k & 1 ? 7 : -7, k & 2 ? 3 : -3, k & 4 ? 2 : -2};
    const FilteredVector filtered(point, 0);
    const NudgedPoint x(filtered.rounded, [&]() -> NudgedPoint::Exact {
      return {point, Integer(1), along, {along[1], Integer(-along[0]), along[2]}};
    });
    if (!collision.contains(x)) return false;
  }
  return true;
}

struct Pair {
  Polyhedron P, Q;
};

/// A ring and a block with a cavity, under a matrix, and what is random.
Pair pair_of(std::mt19937& dice) {
  const auto matrix = polycubes::random_matrix(dice, 40);
  const Cells ring = without(block({0, 0, 0}, {7, 7, 2}), block({2, 2, 0}, {5, 5, 2}));
  const Cells hollow = without(block({0, 0, 0}, {5, 5, 5}), block({2, 2, 2}, {3, 3, 3}));
  switch (number(dice, 0, 2)) {
    case 0:
      return {solid(ring, matrix), solid(hollow, matrix)};
    case 1:
      return {solid(ring, matrix), bodies::random_body(dice, 200)};
    default:
      return {solid(hollow, matrix), solid(ring, polycubes::random_matrix(dice, 40))};
  }
}

TEST(InteriorCells, AreThoseOfACubeWhoseFirstCellLiesBelowADiagonal) {
  const Polyhedron cube = bodies::box(96, 96, 96);
  const SpaceOperands operands = space_operands(cube, cube, unit);
  const InteriorCells cells(operands.P, operands.Q, 100000);
  const BoundedVector middle = FilteredVector({96, 96, 96}, 0).rounded;
  EXPECT_TRUE(cells.contain({&middle, 1}));
}

TEST(InteriorCells, WhatTheyContainIsInTheInterior) {
  std::size_t contained = 0;
  for_each_seed(24, [&](std::mt19937& dice) {
    const auto [P, Q] = pair_of(dice);
    const SpaceOperands operands = space_operands(P, Q, unit);
    const InteriorCells cells(operands.P, operands.Q, 100000);
    const CollisionTrees trees(operands.P, operands.Q, {});
    Collision collision(trees);
    std::vector<IntegerVector> points;
    for (const ConvolutionFacet& facet : convolution_facets(operands.P, operands.Q).facets) {
      for (std::size_t k = 0; k < facet.size; ++k) points.push_back(facet.corners[k].exact);
    }
    for (int k = 0; k < 1000; ++k) {
      // Three points somewhere between corners of facets, not far from each other.
      std::array<IntegerVector, 4> corners{};
      for (std::size_t j = 0; j < 3; ++j) {
        const IntegerVector &a = points[dice() % points.size()],
                            &b = points[dice() % points.size()];
        for (std::size_t i = 0; i < 3; ++i) {
          corners[j][i] = j == 0 ? Integer((a[i] + b[i]) / 2)
                                 : Integer(corners[0][i] + (a[i] - b[i]) / number(dice, 3, 9));
        }
      }
      for (IntegerVector& point : corners) {
        for (Integer& c : point) c -= c % 3;  // so that the middle is an integer point
      }
      std::array<BoundedVector, 3> rounded;
      for (std::size_t j = 0; j < 3; ++j) rounded[j] = FilteredVector(corners[j], 0).rounded;
      if (!cells.contain(rounded)) continue;
      ++contained;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[3][i] = (corners[0][i] + corners[1][i] + corners[2][i]) / 3;
      }
      for (const IntegerVector& point : corners) ASSERT_TRUE(is_interior(collision, point));
    }
  });
  EXPECT_GT(contained, 500U);
}

/// Takes boxes with sides just beyond borders of cells: the margin for errors is small.
TEST(InteriorCells, NoPointOfTheBoundaryIsContained) {
  constexpr int picked = 4;
  const Scaling wide{picked, picked, picked};  // so that means are integer points
  std::size_t looked_at = 0;
  for_each_seed(20, [&](std::mt19937& dice) {
    const auto side = [&] { return 64 * number(dice, 2, 6) + 2; };
    const Polyhedron body = bodies::box(side(), side(), side());
    const Polyhedron P = scaled(translated(body, {-1, -1, -1}), wide),
                     Q = scaled(bodies::random_body(dice, 200), wide);
    const SpaceOperands operands = space_operands(P, Q, unit);
    const InteriorCells cells(operands.P, operands.Q, 100000);
    const Polyhedron sum = bodies::sum(P, Q, unit).surface;
    for (const Face& face : sum.faces) {
      for (int round = 0; round < 100; ++round) {
        IntegerVector point{0, 0, 0};
        for (int k = 0; k < picked; ++k) {
          const SpacePoint& v = sum.vertices[face[dice() % face.size()]];
          point = point + IntegerVector{numerator(v.x), numerator(v.y), numerator(v.z)};
        }
        for (Integer& c : point) c /= picked;
        const FilteredVector at(point, 0);
        ASSERT_FALSE(cells.contain({&at.rounded, 1}));
        ++looked_at;
      }
    }
  });
  EXPECT_GT(looked_at, 10000U);
}

TEST(InteriorCells, NothingIsContainedInASumOfThinParts) {
  const Polyhedron plate = bodies::box(100, 100, 1), needle = bodies::box(1, 1, 100);
  const SpaceOperands operands = space_operands(plate, needle, unit);
  const InteriorCells cells(operands.P, operands.Q, 4096);
  const FilteredVector corner({0, 0, 0}, 0);
  EXPECT_FALSE(cells.contain({&corner.rounded, 1}));
}

/// Omitting covered facets leaves the sum unchanged.
TEST(InteriorCells, TheSumIsTheSameWithoutCoveredFacets) {
  std::uint64_t covered = 0;
  for_each_seed(12, [&](std::mt19937& dice) {
    const auto matrix = polycubes::random_matrix(dice, 5);
    const Cells ring = without(block({0, 0, 0}, {8, 7, 3}), block({3, 2, 0}, {5, 5, 3}));
    const Cells other = without(block({0, 0, 0}, {5, 5, 4}), block({1, 2, 3}, {5, 3, 4}));
    const EdgeSum sum = edge_sum(solid(ring, matrix), solid(other, matrix), unit);
    covered += sum.covered_facets;
    EXPECT_EQ(canonical_json(sum.set),
              canonical_json(polyhedral_set(solid(polycubes::sum_of_cells(ring, other), matrix))));
  });
  EXPECT_GT(covered, 100U);
}

}  // namespace
}  // namespace minkref::of_interior_cells
