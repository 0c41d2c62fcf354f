// Sums of solids of unit cells, compared with counted cells.
#include <gtest/gtest.h>

#include <string>

#include "reference/error.hpp"
#include "reference/space/definition/definition_sum.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_polycube_sums {
namespace {

using bodies::for_each_seed;
using polycubes::block;
using polycubes::Cells;
using polycubes::determinant;
using polycubes::identity;
using polycubes::Matrix;
using polycubes::solid;
using polycubes::sum_of_cells;
using polycubes::with;
using polycubes::without;

void expect_sum_of_cells(const Cells& a, const Cells& b, const Matrix& m = identity) {
  const PolyhedralSet found = definition_sum(solid(a, m), solid(b, m), bodies::unit);
  const Cells expected = sum_of_cells(a, b);
  EXPECT_EQ(volume(found), Rational(expected.size()) * determinant(m));
  EXPECT_EQ(canonical_json(found), canonical_json(polyhedral_set(solid(expected, m))));
}

TEST(PolycubeSum, OfCubes) {
  expect_sum_of_cells(block({0, 0, 0}, {1, 1, 1}), block({2, 3, 4}, {3, 4, 5}));
}

TEST(PolycubeSum, OfAnLAndACube) {
  const Cells L = with(block({0, 0, 0}, {3, 1, 1}), block({0, 1, 0}, {1, 3, 1}));
  expect_sum_of_cells(L, block({0, 0, 0}, {1, 1, 1}));
}

TEST(PolycubeSum, OfACupAndAPlate) {
  const Cells cup = without(block({0, 0, 0}, {5, 5, 5}), block({1, 1, 1}, {4, 4, 5}));
  expect_sum_of_cells(cup, block({0, 0, 0}, {1, 7, 7}));
  expect_sum_of_cells(cup, block({0, 0, 0}, {7, 7, 1}));
  expect_sum_of_cells(cup, block({0, 0, 0}, {2, 2, 1}));
}

TEST(PolycubeSum, OfACavityLeavesOneWhereTheOtherFitsIn) {
  const Cells shell = without(block({0, 0, 0}, {5, 5, 5}), block({1, 1, 1}, {4, 4, 4}));
  expect_sum_of_cells(shell, block({0, 0, 0}, {1, 1, 1}));
  expect_sum_of_cells(shell, block({0, 0, 0}, {1, 2, 1}));
}

TEST(PolycubeSum, FillsACavityThatTheOtherFitsInTightly) {
  const Cells shell = without(block({0, 0, 0}, {3, 3, 3}), block({1, 1, 1}, {2, 2, 2}));
  const Cells cube = block({0, 0, 0}, {1, 1, 1});
  expect_sum_of_cells(shell, cube);
  EXPECT_EQ(volume(definition_sum(solid(shell), solid(cube), bodies::unit)), 64);
  const Scaling wider{Rational(11, 10), Rational(11, 10), Rational(11, 10)};
  const Rational edge(43, 10), hollow(1, 10);
  EXPECT_EQ(volume(definition_sum(solid(shell), solid(cube), wider)),
            edge * edge * edge - hollow * hollow * hollow);
}

TEST(PolycubeSum, OfAFrameKeepsItsTunnel) {
  const Cells frame = without(block({0, 0, 0}, {5, 5, 1}), block({1, 1, 0}, {4, 4, 1}));
  expect_sum_of_cells(frame, block({0, 0, 0}, {1, 1, 1}));
  expect_sum_of_cells(frame, block({0, 0, 0}, {1, 3, 1}));
  expect_sum_of_cells(frame, frame);
}

TEST(PolycubeSum, OfSeveralComponents) {
  const Cells two = with(block({0, 0, 0}, {1, 1, 1}), block({3, 0, 0}, {4, 2, 1}));
  expect_sum_of_cells(two, two);
  expect_sum_of_cells(two, block({0, 0, 0}, {2, 1, 1}));
}

TEST(PolycubeSum, OfRandomCells) {
  for_each_seed(40, [&](std::mt19937& dice) {
    expect_sum_of_cells(polycubes::random_cells(dice, 14, 4), polycubes::random_cells(dice, 7, 3));
  });
}

TEST(PolycubeSum, OfScaledOperandsIsTheScaledSum) {
  for_each_seed(20, [&](std::mt19937& dice) {
    const Cells a = polycubes::random_cells(dice, 8, 3), b = polycubes::random_cells(dice, 5, 3);
    const Scaling s = bodies::random_scaling(dice);
    EXPECT_EQ(canonical_json(definition_sum(solid(a), scaled(solid(b), s), s)),
              canonical_json(polyhedral_set(scaled(solid(sum_of_cells(a, b)), s))));
  });
}

TEST(PolycubeSum, OfCoordinatesBeyondTheDoubles) {
  const Rational huge("1" + std::string(320, '0')), tiny = 1 / huge, third(1, 3);
  for (const Scaling& s : {Scaling{huge, tiny, third}, Scaling{tiny, tiny, tiny},
                           Scaling{huge, huge, huge}, Scaling{tiny, 1, huge}}) {
    const Cells a = with(block({0, 0, 0}, {3, 1, 1}), block({0, 1, 0}, {1, 3, 2}));
    const Cells b = without(block({0, 0, 0}, {3, 3, 1}), block({1, 1, 0}, {2, 2, 1}));
    const Matrix m{{{1, 2, 0}, {-1, 1, 1}, {0, 1, 3}}};
    const SpacePoint far{huge, 1, -huge};
    const Polyhedron P = scaled(solid(a, m), s), Q = translated(scaled(solid(b, m), s), far);
    const Polyhedron expected = translated(scaled(solid(sum_of_cells(a, b), m), s), far);
    EXPECT_EQ(canonical_json(definition_sum(P, Q, bodies::unit)),
              canonical_json(polyhedral_set(expected)));
  }
}

TEST(PolycubeSum, OfAFitThatIsAlmostTight) {
  const Cells shell = without(block({0, 0, 0}, {3, 3, 3}), block({1, 1, 1}, {2, 2, 2}));
  const Polyhedron cube = solid(block({0, 0, 0}, {1, 1, 1}));
  const Rational little("1/1" + std::string(40, '0'));
  for (const Rational& s : {Rational(1 - little), Rational(1 + little)}) {
    const Rational edge = 3 * s + 1, hollow = s > 1 ? Rational(s - 1) : Rational(0);
    EXPECT_EQ(volume(definition_sum(solid(shell), cube, {s, s, s})),
              edge * edge * edge - hollow * hollow * hollow);
  }
}

TEST(PolycubeSum, OfRandomCellsUnderAMatrix) {
  for_each_seed(40, [&](std::mt19937& dice) {
    expect_sum_of_cells(polycubes::random_cells(dice, 9, 3), polycubes::random_cells(dice, 6, 3),
                        polycubes::random_matrix(dice, 5));
  });
}

}  // namespace
}  // namespace minkref::of_polycube_sums
