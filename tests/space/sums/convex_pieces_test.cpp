// The convex pieces of a solid.
#include "reference/space/definition/convex_pieces.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/space/definition/merged_pieces.hpp"
#include "tests/space/convex/bodies.hpp"
#include "tests/space/sums/polycubes.hpp"

namespace minkref::of_convex_pieces {
namespace {

using bodies::at;
using bodies::for_each_seed;
using polycubes::block;
using polycubes::Cells;
using polycubes::solid;
using polycubes::with;
using polycubes::without;

/// Checks that the pieces are convex, have the promised form and add up to the whole volume;
/// returns their count.
std::size_t checked_count(const Polyhedron& surface) {
  Rational rest = sextuple_volume(surface);
  const std::vector<Polyhedron> pieces = convex_pieces(surface);
  for (const Polyhedron& piece : pieces) {
    validate(piece);
    const ConvexPolyhedron body(piece);
    EXPECT_EQ(body.facets(), piece.faces.size());
    EXPECT_EQ(body.vertices(), piece.vertices.size());
    rest -= sextuple_volume(piece);
  }
  EXPECT_EQ(rest, 0);
  return pieces.size();
}

TEST(ConvexPieces, AConvexSolidIsOne) {
  for_each_seed(30, [&](std::mt19937& dice) {
    const Polyhedron body = bodies::random_body(dice, 5);
    EXPECT_EQ(checked_count(body), 1U);
    EXPECT_EQ(bodies::canonical(convex_pieces(body)[0]), bodies::canonical(body));
  });
}

TEST(ConvexPieces, OfPlainSolids) {
  const Cells L = with(block({0, 0, 0}, {3, 1, 1}), block({0, 1, 0}, {1, 3, 1}));
  EXPECT_EQ(checked_count(solid(L)), 2U);
  const Cells cube = block({0, 0, 0}, {3, 3, 3});
  EXPECT_EQ(checked_count(solid(without(cube, block({1, 1, 1}, {2, 2, 3})))), 5U);
  EXPECT_EQ(checked_count(solid(without(cube, block({1, 1, 1}, {2, 2, 2})))), 6U);
  EXPECT_EQ(checked_count(solid(without(cube, block({1, 1, 0}, {2, 2, 3})))), 4U);
  const Cells apart = with(block({0, 0, 0}, {1, 1, 1}), block({1, 0, 1}, {2, 3, 2}));
  EXPECT_EQ(checked_count(solid(apart)), 2U);
}

TEST(ConvexPieces, OfASolidWithANotchAcrossAFaceThatIsNotConvex) {
  // A prism over a non-convex polygon: both ends have six corners.
  const Polyhedron prism{{at(0, 0, 0), at(4, 0, 0), at(4, 3, 0), at(2, 1, 0), at(0, 3, 0),
                          at(0, 0, 2), at(4, 0, 2), at(4, 3, 2), at(2, 1, 2), at(0, 3, 2)},
                         {{0, 4, 3, 2, 1},
                          {5, 6, 7, 8, 9},
                          {0, 1, 6, 5},
                          {1, 2, 7, 6},
                          {2, 3, 8, 7},
                          {3, 4, 9, 8},
                          {4, 0, 5, 9}}};
  validate(prism);
  EXPECT_EQ(checked_count(prism), 2U);
}

TEST(ConvexPieces, OfRandomCells) {
  for_each_seed(40, [&](std::mt19937& dice) {
    const Cells cells = polycubes::random_cells(dice, 20, 4);
    EXPECT_LE(checked_count(solid(cells, polycubes::random_matrix(dice, 4))), 20U);
  });
}

TEST(ConvexPieces, APointAndASegmentAreTheirOwn) {
  const Polyhedron point{{at(1, 2, 3)}, {}}, segment{{at(1, 2, 3), at(0, 0, 0)}, {}};
  EXPECT_EQ(convex_pieces(point), std::vector{point});
  EXPECT_EQ(convex_pieces(segment), std::vector{segment});
  EXPECT_TRUE(convex_pieces({}).empty());
}

Polyhedron both(Polyhedron first, const Polyhedron& second) {
  const auto count = static_cast<std::uint32_t>(first.vertices.size());
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (Face face : second.faces) {
    for (std::uint32_t& v : face) v += count;
    first.faces.push_back(face);
  }
  return first;
}

TEST(ConvexPieces, RefusesASurfaceThatCoversItselfOrCrossesItself) {
  const Polyhedron cube = bodies::box(1, 1, 1);
  EXPECT_THROW(convex_pieces(both(cube, translated(cube, {1, 0, 0}))), BadInput);
  EXPECT_THROW(convex_pieces(both(cube, cube)), BadInput);
  const Rational half(1, 2);
  EXPECT_THROW(convex_pieces(both(cube, translated(cube, {half, half, half}))), BadInput);
  EXPECT_EQ(checked_count(both(cube, translated(cube, {2, half, half}))), 2U);
}

TEST(MergedPieces, JoinsThoseWhoseUnionIsConvex) {
  const Polyhedron cube = bodies::box(1, 1, 1), next = translated(cube, {1, 0, 0});
  const std::vector<Polyhedron> one = merged_pieces({cube, next});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(bodies::canonical(one[0]), bodies::canonical(bodies::box(2, 1, 1)));
  EXPECT_EQ(merged_pieces({cube, translated(cube, {2, 0, 0})}).size(), 2U);
  EXPECT_EQ(merged_pieces({cube, translated(cube, {1, Rational(1, 2), 0})}).size(), 2U);
  EXPECT_EQ(merged_pieces({cube, next, translated(cube, {0, 1, 0})}).size(), 2U);
  EXPECT_EQ(
      merged_pieces({cube, next, translated(cube, {0, 1, 0}), translated(cube, {1, 1, 0})}).size(),
      1U);
}

}  // namespace
}  // namespace minkref::of_convex_pieces
