#include "reference/space/surface/rounded_mesh.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"

namespace minkref::of_rounded_mesh {
namespace {

/// A tetrahedron with its tip above the origin.
Polyhedron tetrahedron(const Rational& side, const Rational& height) {
  return {{{0, 0, 0}, {side, 0, 0}, {0, side, 0}, {0, 0, height}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TEST(RoundedMesh, ShortNumbersStay) {
  const RoundedMesh rounded = rounded_mesh(tetrahedron(3, Rational(1, 4)), Precision::float32);
  EXPECT_EQ(rounded.mesh, tetrahedron(3, Rational(1, 4)));
  EXPECT_EQ(rounded.report.moved_vertices, 0U);
  EXPECT_EQ(rounded.report.largest_displacement, 0);
}

TEST(RoundedMesh, TheLargestDisplacementIsExact) {
  const Rational third(1, 3);
  const RoundedMesh rounded = rounded_mesh(tetrahedron(third, 1));
  EXPECT_EQ(rounded.report.moved_vertices, 2U);
  EXPECT_EQ(rounded.report.largest_displacement, third - from_double(1.0 / 3));
  EXPECT_EQ(rounded.report.merged_vertices, 0U);
  EXPECT_EQ(rounded.report.degenerate_faces, 0U);
  EXPECT_EQ(rounded.report.turned_faces, 0U);
  EXPECT_EQ(rounded.mesh.faces, tetrahedron(third, 1).faces);
  const RoundedMesh coarse = rounded_mesh(tetrahedron(third, 1), Precision::float32);
  EXPECT_EQ(coarse.mesh.vertices[1].x, from_double(1.0F / 3.0F));
}

TEST(RoundedMesh, AFloatIsRoundedOnce) {
  // Half-way between two floats, and a little more or less than a double can tell.
  const Rational even(1), half = even + Rational(1, 1 << 24), odd = even + Rational(1, 1 << 23);
  const Rational little = Rational(1, Integer(1) << 100);
  const auto rounded = [&](const Rational& x) {
    return rounded_mesh({{{x, -x, 0}}, {}}, Precision::float32).mesh.vertices[0];
  };
  EXPECT_EQ(rounded(half - little), (SpacePoint{even, -even, 0}));
  EXPECT_EQ(rounded(half), (SpacePoint{even, -even, 0}));
  EXPECT_EQ(rounded(half + little), (SpacePoint{odd, -odd, 0}));
  const Rational next_half = odd + Rational(1, 1 << 24), next = odd + Rational(1, 1 << 23);
  EXPECT_EQ(rounded(next_half - little), (SpacePoint{odd, -odd, 0}));
  EXPECT_EQ(rounded(next_half), (SpacePoint{next, -next, 0}));
}

TEST(RoundedMesh, FlatVerticesMerge) {
  const Rational tiny(Integer(1), Integer(10) * boost::multiprecision::pow(Integer(10), 400U));
  const RoundedMesh rounded = rounded_mesh(tetrahedron(1, tiny));
  EXPECT_EQ(rounded.report.merged_vertices, 1U);
  // The bottom face stays, the face over it coincides with the bottom, and two faces shrink to
  // edges.
  EXPECT_EQ(rounded.report.degenerate_faces, 2U);
  EXPECT_EQ(rounded.report.largest_displacement, tiny);
}

TEST(RoundedMesh, TrianglesTurnOver) {
  // A sliver whose tip lies right of its base by less than half a unit in the last place.
  const Rational big(Integer(1) << 54);
  const auto sliver = [&](const Rational& tip) {
    return Polyhedron{{{0, 0, 0}, {big, big, 0}, {big - tip, big + tip, 0}}, {{0, 1, 2}}};
  };
  EXPECT_EQ(rounded_mesh(sliver(1)).report.degenerate_faces, 1U);
  const Polyhedron turning{{{big + 1, big + Rational(5, 4), 0}, {0, 0, 0}, {big + 3, big + 3, 0}},
                           {{0, 2, 1}}};
  const RoundedMesh rounded = rounded_mesh(turning);
  EXPECT_EQ(rounded.report.turned_faces + rounded.report.degenerate_faces, 1U);
}

TEST(RoundedMesh, PolygonsBend) {
  const Rational third(1, 3);
  const Rational seventh(1, 7);
  const Polyhedron square{{{0, 0, 0}, {1, 0, third}, {1, 1, third + seventh}, {0, 1, seventh}},
                          {{0, 1, 2, 3}}};
  const RoundedMesh rounded = rounded_mesh(square, Precision::float32);
  EXPECT_EQ(rounded.report.bent_faces, 1U);
  EXPECT_EQ(rounded.report.degenerate_faces, 0U);
  EXPECT_EQ(rounded.report.turned_faces, 0U);
}

TEST(RoundedMesh, Refusals) {
  const Rational huge(Integer(1) << 1100);
  EXPECT_THROW(rounded_mesh(tetrahedron(huge, 1)), LimitExceeded);
  EXPECT_THROW(rounded_mesh(tetrahedron(Rational(Integer(1) << 128), 1), Precision::float32),
               LimitExceeded);
  const Polyhedron crossed{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  EXPECT_THROW(rounded_mesh(crossed), BadInput);
}

}  // namespace
}  // namespace minkref::of_rounded_mesh
