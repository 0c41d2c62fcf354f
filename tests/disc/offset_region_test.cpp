// Components, holes and the canonical form of sums with a disc.
#include "reference/disc/region/offset_region.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "reference/error.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::of_offset_region {
namespace {

Ring box(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

std::pair<std::size_t, std::size_t> counts(const PolygonSet& P, const Rational& squared_radius) {
  const OffsetRegion region = offset_region(P, squared_radius);
  return {region.components.size(), region.holes};
}

using Counts = std::pair<std::size_t, std::size_t>;

TEST(OffsetRegion, OfAPointIsOneCircle) {
  EXPECT_EQ(canonical_json(offset_region({{{{{1, 2}}, {}}}}, Rational(2))),
            R"({"components":[{"holes":[],"outer":[["arc","1","2"]]}],"squared_radius":"2"})");
}

TEST(OffsetRegion, OfASegmentHasTwoLinesAndTwoArcs) {
  EXPECT_EQ(canonical_json(offset_region({{{{{0, 0}, {6, 8}}, {}}}}, Rational(4))),
            R"({"components":[{"holes":[],"outer":[["arc","0","0"],["line","3","4","0"],)"
            R"(["arc","6","8"],["line","-3","-4","0"]]}],"squared_radius":"4"})");
}

TEST(OffsetRegion, OfNothingIsEmpty) {
  EXPECT_EQ(canonical_json(offset_region({}, Rational(1))),
            R"({"components":[],"squared_radius":"1"})");
}

TEST(OffsetRegion, RefusesARadiusThatIsNone) {
  EXPECT_THROW(offset_region({{{box(0, 0, 1, 1), {}}}}, Rational(0)), BadInput);
}

/// Corners 5 apart: touching discs do not join the components around them.
TEST(OffsetRegion, JoinsWhatOverlapsAndNotWhatTouches) {
  const PolygonSet P{{{box(0, 0, 1, 1), {}}, {box(4, 5, 5, 6), {}}}};
  EXPECT_EQ(counts(P, Rational(24, 4)), Counts(2, 0));
  EXPECT_EQ(counts(P, Rational(25, 4)), Counts(2, 0));
  EXPECT_EQ(counts(P, Rational(26, 4)), Counts(1, 0));
}

/// Facing edges 2 apart: all points between them are inside once the discs reach the middle.
TEST(OffsetRegion, JoinsAcrossARidge) {
  const PolygonSet P{{{box(0, 0, 1, 3), {}}, {box(3, 1, 4, 9), {}}}};
  EXPECT_EQ(counts(P, Rational(99, 100)), Counts(2, 0));
  EXPECT_EQ(counts(P, Rational(1)), Counts(1, 0));
  EXPECT_EQ(counts(P, Rational(101, 100)), Counts(1, 0));
  // Edges that face each other at a single point do not join.
  const PolygonSet Q{{{box(0, 0, 1, 3), {}}, {box(3, 3, 4, 9), {}}}};
  EXPECT_EQ(counts(Q, Rational(1)), Counts(2, 0));
}

/// The first polygon joins the others, although it has no part in their hole.
TEST(OffsetRegion, JoinsAcrossARidgeAlsoWithoutACommonRing) {
  const Ring open{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {6, 6}, {6, 8}, {0, 8}};
  const PolygonSet P{{{box(-4, 3, -2, 5), {}}, {open, {}}, {box(8, 0, 10, 8), {}}}};
  EXPECT_EQ(counts(P, Rational(99, 100)), Counts(3, 0));
  EXPECT_EQ(counts(P, Rational(1)), Counts(1, 1));
  EXPECT_EQ(counts(P, Rational(101, 100)), Counts(1, 1));
}

/// A bump on a long plate: the plate's edge is nearer to both ends of the arc about the bump's tip,
/// and farther from the arc's middle.
TEST(OffsetRegion, AnEdgeBlocksBothEndsOfAnArc) {
  const PolygonSet P{{{{{-6, -5}, {6, -5}, {0, 0}}, {}}, {box(-300, -20, 300, -6), {}}}};
  const OffsetRegion found = offset_region(P, Rational(10000));
  EXPECT_EQ(canonical_json(found),
            canonical_json(offset_region(P, Rational(10000), {}, OffsetRoute::paper)));
  ASSERT_EQ(found.components.size(), 1U);
  EXPECT_EQ(found.components[0].outer.curves.size(), 10U);
}

/// A frame with a slit between two points: the ring touches itself at the slit, and is split.
TEST(OffsetRegion, HasAHoleWhereItsBoundaryTouchesItself) {
  const PolygonSet P{{{{{0, 0},
                        {12, 0},
                        {12, 5},
                        {11, 5},
                        {11, 1},
                        {1, 1},
                        {1, 11},
                        {11, 11},
                        {11, 7},
                        {12, 7},
                        {12, 12},
                        {0, 12}},
                       {}}}};
  EXPECT_EQ(counts(P, Rational(99, 100)), Counts(1, 0));
  EXPECT_EQ(counts(P, Rational(1)), Counts(1, 1));
  // The same with facing points.
  const PolygonSet Q{{{{{0, 0},
                        {12, 0},
                        {12, 4},
                        {11, 5},
                        {10, 4},
                        {10, 1},
                        {1, 1},
                        {1, 11},
                        {10, 11},
                        {10, 8},
                        {11, 7},
                        {12, 8},
                        {12, 12},
                        {0, 12}},
                       {}}}};
  EXPECT_EQ(counts(Q, Rational(99, 100)), Counts(1, 0));
  EXPECT_EQ(counts(Q, Rational(1)), Counts(1, 1));
  EXPECT_EQ(counts(Q, Rational(101, 100)), Counts(1, 1));
}

/// Two points pinch the hole of a frame into two holes.
TEST(OffsetRegion, CountsAPinchedHoleTwice) {
  const PolygonSet P{{{box(0, 0, 20, 12),
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
  EXPECT_EQ(counts(P, Rational(399, 100)), Counts(1, 1));
  EXPECT_EQ(counts(P, Rational(4)), Counts(1, 2));
  EXPECT_EQ(counts(P, Rational(401, 100)), Counts(1, 2));
}

TEST(OffsetRegion, LeavesStraightVerticesAndStartsOut) {
  const PolygonSet P{{{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {}}}},
      Q{{{{{4, 0}, {4, 1}, {4, 3}, {2, 3}, {0, 3}, {0, 0}}, {}}}};
  EXPECT_EQ(canonical_json(offset_region(P, Rational(2))),
            canonical_json(offset_region(Q, Rational(2))));
}

/// Steiner's formula for a convex set.
TEST(OffsetRegion, HasTheAreaAndLengthOfSteiner) {
  const OffsetMeasures found = measures(offset_region({{{box(0, 0, 4, 3), {}}}}, Rational(9, 4)));
  const double area = 12 + 14 * 1.5 + std::numbers::pi * 2.25, length = 14 + std::numbers::pi * 3;
  EXPECT_LE(found.area.lower(), area);
  EXPECT_GE(found.area.upper(), area);
  EXPECT_LT(found.area.upper() - found.area.lower(), 1e-12);
  EXPECT_LE(found.length.lower(), length);
  EXPECT_GE(found.length.upper(), length);
  EXPECT_LT(found.length.upper() - found.length.lower(), 1e-12);
}

/// Mirrored at the diagonal, moved, and grown: curves, components and holes go along.
TEST(OffsetRegion, KeepsItsCountsUnderSimilarities) {
  for (unsigned seed = 0; seed < testing::repetitions(60U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_mesh_region(random, 2);
    PolygonSet moved = P;
    for (Polygon& polygon : moved.polygons) {
      const auto move = [](Ring& ring) {
        for (Point& p : ring) p = {3 * p.y + Rational(1, 7), -3 * p.x};
      };
      move(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), move);
    }
    for (const int eighths : {1, 2, 4, 8, 9, 10, 16, 50}) {
      const Rational square(eighths, 8);
      const OffsetRegion a = offset_region(P, square), b = offset_region(moved, 9 * square);
      ASSERT_EQ(a.components.size(), b.components.size());
      ASSERT_EQ(a.holes, b.holes);
      ASSERT_NEAR(measures(b).length.lower() / measures(a).length.lower(), 3, 1e-9);
    }
  }
}

/// All arithmetics: coordinates that are no doubles, and far from the origin.
TEST(OffsetRegion, DoesNotDependOnWhatDoublesTell) {
  std::uint64_t exact = 0;
  for (unsigned seed = 0; seed < testing::repetitions(20U); ++seed) {
    SCOPED_TRACE(seed);
    testing::Source random(seed);
    const PolygonSet P = testing::random_mesh_region(random, 2);
    const Rational far("1000000000000000000000000/3");
    PolygonSet moved = P;
    for (Polygon& polygon : moved.polygons) {
      const auto move = [&](Ring& ring) {
        for (Point& p : ring) p = {p.x + far, p.y - far};
      };
      move(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), move);
    }
    for (const int eighths : {2, 9}) {
      const OffsetRegion a = offset_region(P, Rational(eighths, 8)),
                         b = offset_region(moved, Rational(eighths, 8));
      exact += b.offset.counts.exact_pairs;
      ASSERT_EQ(a.components.size(), b.components.size());
      ASSERT_EQ(a.holes, b.holes);
      ASSERT_EQ(a.offset.pieces.size(), b.offset.pieces.size());
    }
  }
  EXPECT_GT(exact, 0U);
}

}  // namespace
}  // namespace minkref::of_offset_region
