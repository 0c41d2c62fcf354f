// Sums with a disc from winding numbers of the convolution: known shapes, and the law that both
// routes give one canonical form.
#include "reference/disc/convolution/arc_convolution.hpp"

#include <gtest/gtest.h>

#include "reference/disc/region/offset_region.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_arc_convolution {
namespace {

std::string by(OffsetRoute route, const PolygonSet& P, const Rational& squared_radius) {
  return canonical_json(offset_region(P, squared_radius, {}, route));
}

void expect_one_form(const PolygonSet& P, const Rational& squared_radius) {
  SCOPED_TRACE(squared_radius);
  ASSERT_EQ(by(OffsetRoute::paper, P, squared_radius),
            by(OffsetRoute::definition, P, squared_radius));
}

Ring box(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }
Ring clockwise(Ring ring) { return {ring.rbegin(), ring.rend()}; }

TEST(ArcConvolution, OfAPointIsOneCircle) {
  EXPECT_EQ(by(OffsetRoute::paper, {{{{{1, 2}}, {}}}}, Rational(2)),
            R"({"components":[{"holes":[],"outer":[["arc","1","2"]]}],"squared_radius":"2"})");
}

TEST(ArcConvolution, OfASegmentHasTwoLinesAndTwoArcs) {
  EXPECT_EQ(by(OffsetRoute::paper, {{{{{0, 0}, {6, 8}}, {}}}}, Rational(4)),
            R"({"components":[{"holes":[],"outer":[["arc","0","0"],["line","3","4","0"],)"
            R"(["arc","6","8"],["line","-3","-4","0"]]}],"squared_radius":"4"})");
}

TEST(ArcConvolution, OfNothingIsEmpty) {
  EXPECT_EQ(by(OffsetRoute::paper, {}, Rational(1)), R"({"components":[],"squared_radius":"1"})");
}

/// Without slits, the middle would have a ring's number: 0.
TEST(ArcConvolution, HoldsADiscThatHoldsAHole) {
  const PolygonSet frame{{{box(-9, -9, 9, 9), {clockwise(box(-1, -1, 1, 1))}}}};
  const ArcConvolution found = arc_convolution(frame, Rational(16));
  EXPECT_EQ(found.components, 1U);
  EXPECT_EQ(found.holes, 0U);
  EXPECT_EQ(found.offset.rings.size(), 1U);
}

/// Facing edges 2 ρ apart: the lines between them cancel completely.
TEST(ArcConvolution, JoinsAcrossARidge) {
  const PolygonSet P{{{box(0, 0, 1, 3), {}}, {box(3, 1, 4, 9), {}}}};
  EXPECT_EQ(arc_convolution(P, Rational(99, 100)).components, 2U);
  EXPECT_EQ(arc_convolution(P, Rational(1)).components, 1U);
  expect_one_form(P, Rational(1));
}

TEST(ArcConvolution, DoesNotJoinWhatTouches) {
  const PolygonSet P{{{box(0, 0, 1, 1), {}}, {box(4, 5, 5, 6), {}}}};
  for (const int quarters : {24, 25, 26}) expect_one_form(P, Rational(quarters, 4));
  EXPECT_EQ(arc_convolution(P, Rational(25, 4)).components, 2U);
}

TEST(ArcConvolution, GivesTheFormOfTheDefinitionForRandomRegions) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_region(random, 2);
    for (const Rational& radius : {Rational(1, 3), Rational(1), Rational(7, 4), Rational(30)}) {
      ASSERT_NO_FATAL_FAILURE(expect_one_form(P, radius * radius));
    }
  }
}

/// Rings that touch, holes, facing walls; half the distances between points of a grid.
TEST(ArcConvolution, GivesTheFormOfTheDefinitionForGridsAtCriticalRadii) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_mesh_region(random, 2);
    for (const int eighths : {1, 2, 4, 8, 9, 10, 16, 50}) {
      ASSERT_NO_FATAL_FAILURE(expect_one_form(P, Rational(eighths, 8)));
      ASSERT_NO_FATAL_FAILURE(expect_one_form(P, Rational(eighths * eighths, 64)));
    }
  }
}

/// Turned off the axes, with irrational lengths.
TEST(ArcConvolution, GivesTheFormOfTheDefinitionForTurnedGrids) {
  for (unsigned seed = 0; seed < testing::repetitions(30U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    PolygonSet P = testing::random_mesh_region(random, 2);
    const auto turn = [](Ring& ring) {
      for (Point& p : ring) p = {2 * p.x - p.y, p.x + 2 * p.y};
    };
    for (Polygon& polygon : P.polygons) {
      turn(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), turn);
    }
    for (const int eighths : {1, 2, 4, 8, 9, 10, 16, 50}) {
      ASSERT_NO_FATAL_FAILURE(expect_one_form(P, Rational(5 * eighths, 8)));
      ASSERT_NO_FATAL_FAILURE(expect_one_form(P, Rational(5 * eighths * eighths, 64)));
    }
  }
}

/// Where polygons touch in a vertex their arcs overlap, and count twice.
TEST(ArcConvolution, CountsArcsAboutOneVertexTogether) {
  const PolygonSet P{{{box(0, 0, 2, 2), {}}, {box(2, 2, 4, 4), {}}}};
  for (const int quarters : {1, 4, 16, 32}) expect_one_form(P, Rational(quarters, 4));
  const ArcConvolution found = arc_convolution(P, Rational(1));
  EXPECT_EQ(found.components, 1U);
  EXPECT_EQ(found.holes, 0U);
}

TEST(ArcConvolution, GivesTheFormOfTheDefinitionForSegments) {
  testing::Source random(7);
  for (int k = 0; k < 40; ++k) {
    const Point p{random.between(-5, 5), random.between(-5, 5)};
    const Point q{p.x + random.between(1, 5), p.y + random.between(-5, 5)};
    ASSERT_NO_FATAL_FAILURE(expect_one_form({{{{p, q}, {}}}}, Rational(random.between(1, 30), 4)));
  }
}

/// Two points pinch the hole of a frame, with arms of 3, 4 and 5: discs touch off the axes, at a
/// point on no other curve.
TEST(ArcConvolution, SplitsAHoleWhereArcsTouch) {
  PolygonSet P{{{box(0, 0, 20, 12),
                 {{{1, 1},
                   {1, 11},
                   {9, 11},
                   {10, 8},
                   {11, 11},
                   {19, 11},
                   {19, 1},
                   {11, 1},
                   {10, 4},
                   {9, 1}}}}}};
  const auto turn = [](Ring& ring) {
    for (Point& p : ring) p = {(4 * p.x - 3 * p.y) / 5, (3 * p.x + 4 * p.y) / 5};
  };
  turn(P.polygons[0].outer);
  turn(P.polygons[0].holes[0]);
  EXPECT_EQ(arc_convolution(P, Rational(399, 100)).holes, 1U);
  EXPECT_EQ(arc_convolution(P, Rational(4)).holes, 2U);
  EXPECT_EQ(arc_convolution(P, Rational(401, 100)).holes, 2U);
  for (const int hundredths : {399, 400, 401}) expect_one_form(P, Rational(hundredths, 100));
}

/// As above, an arc and a line.
TEST(ArcConvolution, SplitsAHoleWhereAnArcTouchesALine) {
  PolygonSet P{
      {{box(0, 0, 20, 12), {{{1, 1}, {1, 11}, {9, 11}, {10, 5}, {11, 11}, {19, 11}, {19, 1}}}}}};
  const auto turn = [](Ring& ring) {
    for (Point& p : ring) p = {2 * p.x - p.y, p.x + 2 * p.y};
  };
  turn(P.polygons[0].outer);
  turn(P.polygons[0].holes[0]);
  const Rational critical(20);
  EXPECT_EQ(arc_convolution(P, critical * Rational(99, 100)).holes, 1U);
  EXPECT_EQ(arc_convolution(P, critical).holes, 2U);
  for (const int hundredths : {99, 100, 101}) {
    expect_one_form(P, critical * Rational(hundredths, 100));
  }
}

/// Turned, five times as large in square, and moved so far that doubles tell no two points apart.
PolygonSet far_away(PolygonSet P) {
  const Rational far("1000000000000000000000000/3");
  const auto move = [&](Ring& ring) {
    for (Point& p : ring) p = {2 * p.x - p.y + far, p.x + 2 * p.y - far};
  };
  for (Polygon& polygon : P.polygons) {
    move(polygon.outer);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), move);
  }
  return P;
}

/// Two arcs, and an arc and a line, with both of their crossings.
TEST(ArcConvolution, TellsTwoCrossingsApart) {
  const PolygonSet corners{{{box(0, 0, 1, 1), {}}, {box(2, 2, 3, 3), {}}}},
      above{{{box(-9, -1, 9, 0), {}}, {{{0, 2}, {1, 3}, {0, 4}, {-1, 3}}, {}}}};
  const std::pair<PolygonSet, Rational> cases[] = {{corners, Rational(3, 5)},
                                                   {above, Rational(121, 100)}};
  for (const auto& [P, square] : cases) {
    EXPECT_EQ(arc_convolution(far_away(P), 5 * square).components, 1U);
    expect_one_form(far_away(P), 5 * square);
  }
}

/// A line ends on another line, because the radius equals the height between them.
TEST(ArcConvolution, MeetsACurveWhereAnotherEnds) {
  const PolygonSet P{{{box(-5, -2, 5, 0), {}}, {box(-2, 1, 0, 2), {}}}};
  expect_one_form(P, Rational(1));
  expect_one_form(far_away(P), Rational(5));
}

/// Roots decide where doubles cannot.
TEST(ArcConvolution, DoesNotDependOnWhatDoublesTell) {
  std::uint64_t exact = 0;
  for (unsigned seed = 0; seed < testing::repetitions(12U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = far_away(testing::random_mesh_region(random, 2));
    for (const int eighths : {2, 8, 9, 18}) {
      const Rational square(5 * eighths, 8);
      ASSERT_NO_FATAL_FAILURE(expect_one_form(P, square));
      exact += arc_convolution(P, square).offset.counts.exact_pairs;
    }
  }
  EXPECT_GT(exact, 0U);
}

}  // namespace
}  // namespace minkref::of_arc_convolution
