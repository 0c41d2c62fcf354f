// Sums that people can check by hand, and degenerate contacts.
#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/space/canonical_polyhedron.hpp"
#include "reference/space/convex/segment_sum.hpp"
#include "tests/space/convex/bodies.hpp"

namespace minkref::of_convex_sum_examples {
namespace {

using bodies::at;
using bodies::box;
using bodies::canonical;
using bodies::sum;

/// Each facet of a box has a parallel facet on the other box, for all scalings.
TEST(ConvexSumExample, BoxAndBoxIsABox) {
  for (const Scaling& s : {bodies::unit, Scaling{3, Rational(1, 7), 2}}) {
    const ConvexSum result = sum(box(1, 2, 3), box(4, 1, 5), s);
    Polyhedron expected = box(1, 1, 1);
    expected = scaled(expected, {s[0] * 1 + 4, s[1] * 2 + 1, s[2] * 3 + 5});
    EXPECT_EQ(result.surface, canonical(expected));
    for (const FacetParents& parents : result.facet_parents) {
      EXPECT_EQ(parents.P.size(), 4U);
      EXPECT_EQ(parents.Q.size(), 4U);
    }
  }
}

TEST(ConvexSumExample, CubeAndOctahedronHas26Facets) {
  const ConvexSum result = sum(box(2, 2, 2), bodies::octahedron());
  EXPECT_EQ(result.surface.faces.size(), 26U);
  EXPECT_EQ(result.surface.vertices.size(), 24U);
}

/// One operand has a facet parallel to an edge of the other.
TEST(ConvexSumExample, FacetAndParallelEdgeMakeOneFacet) {
  const Polyhedron wedge{
      {at(0, 0, 0), at(2, 0, 0), at(2, 2, 0), at(0, 2, 0), at(0, 1, 1), at(2, 1, 1)},
      {{0, 3, 2, 1}, {0, 1, 5, 4}, {2, 3, 4, 5}, {0, 4, 3}, {1, 2, 5}}};
  const ConvexSum result = sum(wedge, box(1, 1, 1));
  bool found = false;
  for (const FacetParents& parents : result.facet_parents) {
    found = found || (parents.P.size() == 2 && parents.Q.size() == 4);
  }
  EXPECT_TRUE(found);
}

/// Only a facet of Q changes its vertex of P, and an ee-pair is lost: facets of P alone do not show
/// all errors, contrary to Theorem 1 as printed (Sec. 6).
TEST(ConvexSumExample, AnEeErrorWithoutAnErrorOfAFacetOfP) {
  const ConvexPolyhedron P(
      bodies::tetrahedron(at(0, -3, 5), at(-1, -1, 4), at(-2, 4, -5), at(5, 4, -3)));
  const ConvexPolyhedron Q(
      bodies::tetrahedron(at(1, 5, 1), at(3, 0, 3), at(2, 3, -1), at(-5, -5, 0)));
  DynamicConvexSum moving(P, Q, bodies::unit);
  const UpdateCounts counts = moving.update({9, 3, 4});
  EXPECT_EQ(counts.fv_errors, 0U);
  EXPECT_EQ(counts.vf_errors, 1U);
  EXPECT_GT(counts.ee_errors, 0U);
}

/// All facets exchange two vertices, but all edge pairs stay: the second half of Theorem 1 fails
/// too. The chains run the other way round.
TEST(ConvexSumExample, ErrorsOfAllFacetsWithoutAnEeError) {
  const ConvexPolyhedron P(
      bodies::tetrahedron(at(1, -5, 5), at(-2, -5, 3), at(2, 4, 1), at(-2, 2, -4)));
  const ConvexPolyhedron Q(
      bodies::tetrahedron(at(5, 4, -2), at(-4, -4, -3), at(5, -3, 1), at(-4, 1, -5)));
  DynamicConvexSum moving(P, Q, bodies::unit);
  const UpdateCounts counts = moving.update({5, 5, 1});
  EXPECT_EQ(counts.fv_errors, 4U);
  EXPECT_EQ(counts.vf_errors, 4U);
  EXPECT_EQ(counts.ee_errors, 0U);
  EXPECT_EQ(counts.ee_pairs_added, 0U);
}

TEST(ConvexSumExample, CoplanarTrianglesAndFlatVerticesChangeNothing) {
  // A cube of twelve triangles, with a cut edge and an extra vertex at the bottom's middle.
  const Polyhedron cut{{at(0, 0, 0), at(2, 0, 0), at(2, 2, 0), at(0, 2, 0), at(0, 0, 2),
                        at(2, 0, 2), at(2, 2, 2), at(0, 2, 2), at(1, 1, 0), at(1, 0, 0)},
                       {{8, 9, 0},
                        {8, 1, 9},
                        {8, 2, 1},
                        {8, 3, 2},
                        {8, 0, 3},
                        {4, 5, 6},
                        {4, 6, 7},
                        {0, 9, 5},
                        {0, 5, 4},
                        {9, 1, 5},
                        {1, 2, 6, 5},
                        {2, 3, 7, 6},
                        {3, 0, 4, 7}}};
  EXPECT_EQ(canonical(cut), canonical(box(2, 2, 2)));
  EXPECT_EQ(sum(cut, bodies::octahedron()).surface,
            sum(box(2, 2, 2), bodies::octahedron()).surface);
}

TEST(ConvexSumExample, CanonicalTextIsTheSameForEveryNumbering) {
  const Polyhedron tetrahedron =
      bodies::tetrahedron(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), {0, 0, Rational(1, 2)});
  EXPECT_EQ(canonical_json(canonical(tetrahedron)),
            R"({"faces":[[0,1,2],[0,2,3],[0,3,1],[1,3,2]],"vertices":[["0","0","0"],)"
            R"(["0","0","1/2"],["0","1","0"],["1","0","0"]]})");
}

/// Four facets are parallel to the segment, and swept; two are moved.
TEST(ConvexSumExample, BoxAndSegmentAlongAnAxisIsALongerBox) {
  const ConvexPolyhedron P(box(1, 2, 3));
  const ConvexSum result = sum_with_segment(P, {2, 1, 1}, at(0, 0, 1), at(0, 0, 5));
  Polyhedron expected = translated(box(2, 2, 7), at(0, 0, 1));
  EXPECT_EQ(result.surface, canonical(expected));
  EXPECT_THROW(sum_with_segment(P, bodies::unit, at(1, 1, 1), at(1, 1, 1)), BadInput);
}

/// A zonotope: four segments in general position make a rhombic dodecahedron.
TEST(ConvexSumExample, BoxAndDiagonalSegmentIsARhombicDodecahedron) {
  const ConvexSum result =
      sum_with_segment(ConvexPolyhedron(box(1, 1, 1)), bodies::unit, at(0, 0, 0), at(1, 1, 1));
  EXPECT_EQ(result.surface.faces.size(), 12U);
  EXPECT_EQ(result.surface.vertices.size(), 14U);
  EXPECT_EQ(sextuple_volume(result.surface), 6 * 4);
}

/// Factors far beyond the range of doubles, and ratios that doubles cannot tell from 1.
TEST(ConvexSumExample, HugeAndTinyFactorsAreExact) {
  const ConvexPolyhedron P(bodies::octahedron()), Q(box(1, 2, 3));
  DynamicConvexSum moving(P, Q, bodies::unit);
  const Rational huge = parse_rational("1e500"), tiny = parse_rational("1e-500"), near = 1 + tiny;
  for (const Scaling& s : {Scaling{huge, 1, tiny}, Scaling{near, 1, 1}, Scaling{1, near, 1},
                           Scaling{huge, huge * near, huge}, bodies::unit}) {
    moving.update(s);
    EXPECT_EQ(surface_of(moving).surface,
              sum(scaled(bodies::octahedron(), s), box(1, 2, 3)).surface);
  }
}

/// Doubles round tiny coordinates beside huge ones to 0, but they are nonzero: no check may be
/// skipped.
TEST(ConvexSumExample, CoordinatesOfHugeRatioAreExact) {
  const Rational tiny = parse_rational("1e-400");
  const Polyhedron thin = scaled(bodies::octahedron(), {1, tiny, 1});
  Polyhedron leaning = box(1, 1, 1);
  for (std::size_t k = 4; k < 8; ++k) leaning.vertices[k].y += tiny / 3;
  const ConvexPolyhedron P(thin), Q(leaning);
  DynamicConvexSum moving(P, Q, bodies::unit);
  for (const Scaling& s :
       {Scaling{1, 1 / tiny, 1}, Scaling{1, 1, 2}, Scaling{1, 2, tiny}, bodies::unit}) {
    moving.update(s);
    EXPECT_EQ(surface_of(moving).surface, sum(scaled(thin, s), leaning).surface);
    Contacts contacts(P, Q);
    contacts.rescale(s);
    EXPECT_EQ(moving.compatibility(), by_brute_force(contacts));
  }
}

/// Three factors below all doubles that round to the same double have not the same ratio.
TEST(ConvexSumExample, FactorsBelowAllDoublesAreToldApart) {
  const ConvexPolyhedron P(bodies::octahedron()),
      Q(bodies::tetrahedron(at(0, 0, 0), at(5, 1, 0), at(1, 4, 1), at(0, 1, 6)));
  DynamicConvexSum moving(P, Q, bodies::unit);
  const Rational tiny(1, Integer(1) << 1074);
  const Scaling s{Rational(149, 100) * tiny, Rational(51, 100) * tiny, tiny};
  moving.update(s);
  Contacts contacts(P, Q);
  contacts.rescale(s);
  EXPECT_EQ(moving.compatibility(), by_brute_force(contacts));
}

/// Normals and edges whose products lie far below the least double have no slack.
TEST(ConvexSumExample, ProductsThatUnderflowAreExaminedAgain) {
  const Rational narrow = 1 / Rational(Integer(1) << 180), high = Rational(Integer(1) << 190);
  const Polyhedron P =
      bodies::tetrahedron({0, 0, 0}, {1, narrow, 0}, {narrow, 1, narrow}, {0, narrow, 1});
  const Polyhedron Q =
      bodies::tetrahedron({0, 0, 0}, {1, 0, high}, {0, 1, high / 3}, {1, 1, 1 - high});
  const ConvexPolyhedron p(P), q(Q);
  const Rational wide = Rational(Integer(1) << 95);
  Scaling s{wide, wide, 1 / wide};
  DynamicConvexSum moving(p, q, s);
  Contacts contacts(p, q);
  for (int step = 0; step < 200; ++step) {
    s[static_cast<std::size_t>(step % 3)] *= step % 2 == 0 ? Rational(101, 100) : Rational(98, 100);
    moving.update(s);
    contacts.rescale(s);
    ASSERT_EQ(moving.compatibility(), by_brute_force(contacts)) << step;
  }
}

TEST(ConvexSumExample, AFactorThatIsNotPositiveIsRefusedAndChangesNothing) {
  const ConvexPolyhedron P(bodies::octahedron()), Q(box(1, 2, 3));
  DynamicConvexSum moving(P, Q, bodies::unit);
  EXPECT_THROW(moving.update({1, 0, 1}), BadInput);
  EXPECT_THROW(moving.update({1, 1, -1}), BadInput);
  EXPECT_EQ(moving.scaling(), bodies::unit);
}

}  // namespace
}  // namespace minkref::of_convex_sum_examples
