// Exact fits and scales at which a hole is born or dies, with their derivations.
#include <gtest/gtest.h>

#include "reference/plane/sum.hpp"
#include "reference/plane/witness.hpp"
#include "tests/plane/contact_by_edges.hpp"

namespace minkref::testing::of_critical_scale {
namespace {

const Route routes[] = {Route::paper, Route::winding, Route::definition};

void expect_sum(const PolygonSet& expected, std::size_t components, std::size_t holes,
                const PolygonSet& P, const PolygonSet& Q, const Rational& scale = 1) {
  for (const Route route : routes) {
    const Sum sum = minkowski_sum(P, Q, scale, route);
    EXPECT_EQ(text(sum.region), text(canonicalize(expected).region));
    EXPECT_EQ(sum.components, components);
    EXPECT_EQ(sum.holes, holes);
  }
}

TEST(CriticalScale, SquareThatFitsAHoleExactlyClosesIt) {
  // x - Q fits into the closed hole [1,2]^2 for x = (2,2) only: a point, which has no area.
  const PolygonSet frame = region(rectangle(0, 0, 4, 4), {rectangle(1, 1, 2, 2)});
  const PolygonSet square = box(0, 0, 1, 1);
  expect_sum(box(0, 0, 5, 5), 1, 0, frame, square);
  EXPECT_EQ(decide(frame, square, 1, {2, 2}).contact, Contact::touching);
  EXPECT_EQ(decide(frame, square, 1, {2, Rational(2001, 1000)}).contact, Contact::overlapping);
  // The frame a little larger, or smaller.
  const Rational e = Rational(1) / Rational(Integer(1) << 90);
  const Rational low = 1 + (1 + e), high = 2 * (1 + e);
  expect_sum(
      region(rectangle(0, 0, 4 * (1 + e) + 1, 4 * (1 + e) + 1), {rectangle(low, low, high, high)}),
      1, 1, frame, square, 1 + e);
  expect_sum(box(0, 0, 5 - 4 * e, 5 - 4 * e), 1, 0, frame, square, 1 - e);
}

TEST(CriticalScale, SquareInACorridorOfItsWidthLeavesNoHole) {
  // The hole (1,4)x(1,2) of height 1 and the unit square: contact along [2,4]x{2}.
  const PolygonSet corridor = region(rectangle(0, 0, 5, 3), {rectangle(1, 1, 4, 2)});
  const PolygonSet square = box(0, 0, 1, 1);
  expect_sum(box(0, 0, 6, 4), 1, 0, corridor, square);
  for (const Rational& x : {Rational(2), Rational(3), Rational(4)}) {
    EXPECT_EQ(decide(corridor, square, 1, {x, 2}).contact, Contact::touching);
  }
  EXPECT_EQ(decide(corridor, square, 1, {Rational(4001, 1000), 2}).contact, Contact::overlapping);
}

TEST(CriticalScale, OpenSlotOfTheWidthOfTheOtherOperandFillsUp) {
  // [0,3]^2 less the slot (1,2)x(1,3]: left, right and bottom bars sum to [0,2]x[0,4], [2,4]x[0,4]
  // and [0,4]x[0,2], together [0,4]^2.
  const PolygonSet fork = region({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  const PolygonSet square = box(0, 0, 1, 1);
  expect_sum(box(0, 0, 4, 4), 1, 0, fork, square);
  EXPECT_EQ(decide(fork, square, 1, {2, 3}).contact, Contact::touching);
  EXPECT_EQ(decide(fork, square, 1, {2, 4}).contact, Contact::touching);
  EXPECT_EQ(decide(fork, square, 1, {2, Rational(3, 2)}).contact, Contact::overlapping);
}

TEST(CriticalScale, RingWithAGapOfTheWidthOfTheOtherOperandClosesToAHole) {
  // [0,5]^2 less (1,4)^2 less the gap [4,5]x(2,3): the ring's bars sum to all of [0,6]^2 except
  // (2,4)^2, and the part that passes the gap has height 0.
  const PolygonSet ring = region({{0, 0},
                                  {5, 0},
                                  {5, 2},
                                  {4, 2},
                                  {4, 1},
                                  {1, 1},
                                  {1, 4},
                                  {4, 4},
                                  {4, 3},
                                  {5, 3},
                                  {5, 5},
                                  {0, 5}});
  const PolygonSet square = box(0, 0, 1, 1);
  expect_sum(region(rectangle(0, 0, 6, 6), {rectangle(2, 2, 4, 4)}), 1, 1, ring, square);
  EXPECT_EQ(decide(ring, square, 1, {5, 3}).contact, Contact::touching);
  EXPECT_EQ(decide(ring, square, 1, {3, 3}).contact, Contact::empty);
}

TEST(CriticalScale, TwoSquaresWhoseSumsMeetInAPointStayTwoComponents) {
  // [0,1]^2 and [2,3]^2 with the unit square: [0,2]^2 and [2,4]^2.
  const PolygonSet two = together(box(0, 0, 1, 1), box(2, 2, 3, 3));
  expect_sum(together(box(0, 0, 2, 2), box(2, 2, 4, 4)), 2, 0, two, box(0, 0, 1, 1));
}

TEST(CriticalScale, TriangularHoleDiesWhereThreeEdgesMeetInAPoint) {
  // The hole of sP + Q is {x : x - sP in the hole of Q}. With n_i the inner normal of the hole's
  // side i, n_i.x = h_i there, its sides are n_i.x >= h_i + s max_P n_i.p, and there is an x iff
  // sum of l_i (h_i + s m_i) < 0 for the l_i > 0 with sum of l_i n_i = 0. With
  // A=(0,20), B=(17,-11), C=(-19,-9), clockwise, the edge vectors (17,-31), (-36,2), (19,29) sum to
  // 0, so with the inner normals n = (e.y, -e.x) all l_i are 1:
  //   n = (-31,-17), (2,36), (29,-19)       h = -340, -362, -380       (sum -1082)
  //   max over P of n.p = 127, 110, 135     (at (-3,-2), (1,3), (4,-1); sum 372)
  // so s* = 1082/372 = 541/186, and the hole is there for s < s*.
  const PolygonSet P = region({{-3, -2}, {4, -1}, {1, 3}});
  const PolygonSet Q = region(rectangle(-40, -40, 40, 40), {{{0, 20}, {17, -11}, {-19, -9}}});
  const Rational critical(541, 186), tiny = Rational(1) / Rational(Integer(1) << 40);
  for (const Route route : routes) {
    EXPECT_EQ(minkowski_sum(P, Q, critical - tiny, route).holes, 1U);
    EXPECT_EQ(minkowski_sum(P, Q, critical, route).holes, 0U);
    EXPECT_EQ(minkowski_sum(P, Q, critical + tiny, route).holes, 0U);
    EXPECT_EQ(minkowski_sum(P, Q, critical, route).region.rings(), 1U);
  }
  // The hole is similar to Q's hole, shrunk by (s* - s) / s*: its area is Q's hole area times the
  // square of this ratio.
  const Rational hole = Rational(1082, 2);
  const PolygonSet below = minkowski_sum(P, Q, critical - tiny).region;
  ASSERT_EQ(below.polygons.size(), 1U);
  ASSERT_EQ(below.polygons[0].holes.size(), 1U);
  EXPECT_EQ(-doubled_area(below.polygons[0].holes[0]) / 2,
            hole * (tiny / critical) * (tiny / critical));
  // At s* the three sides n_i.x = h_i + s* m_i meet in one point: solved from the first two and
  // checked against the third.
  const Rational a = -340 + critical * 127, b = -362 + critical * 110;
  const Rational determinant = Rational(-31) * 36 - Rational(-17) * 2;
  const Point x{Rational((a * 36 + 17 * b) / determinant),
                Rational((-31 * b - 2 * a) / determinant)};
  EXPECT_EQ(29 * x.x - 19 * x.y, -380 + critical * 135);
  EXPECT_EQ(decide(P, Q, critical, x).contact, Contact::touching);
  EXPECT_EQ(decide(P, Q, critical - tiny, x).contact, Contact::empty);
  EXPECT_EQ(decide(P, Q, critical + tiny, x).contact, Contact::overlapping);
}

TEST(CriticalScale, HoleSplitsInTwoWhereItsWaistBecomesTooNarrow) {
  // The hole is an hourglass with waist 2, so 2s after scaling. The unit square, straddling the
  // waist, has a width of 2s to itself: it passes iff 2s > 1. At s = 1/2 the hole has height 3, and
  // width 3 at top and bottom, with room for the square on either side.
  const PolygonSet frame =
      region(rectangle(-9, -9, 15, 15), {{{0, 0}, {6, 0}, {4, 3}, {6, 6}, {0, 6}, {2, 3}}});
  const PolygonSet unit = box(0, 0, 1, 1);
  const Rational tiny = Rational(1) / Rational(Integer(1) << 50);
  for (const Route route : routes) {
    const Sum wide = minkowski_sum(frame, unit, Rational(1, 2) + tiny, route);
    const Sum tight = minkowski_sum(frame, unit, Rational(1, 2), route);
    const Sum narrow = minkowski_sum(frame, unit, Rational(1, 2) - tiny, route);
    EXPECT_EQ(wide.holes, 1U);
    EXPECT_EQ(tight.holes, 2U);
    EXPECT_EQ(narrow.holes, 2U);
  }
}

}  // namespace
}  // namespace minkref::testing::of_critical_scale
