// Where rings touch, the closed sum covers points that the sum of the interiors misses. One edge
// shows this, or none: then a tight passage runs across a face of an inner edge.
#include <gtest/gtest.h>

#include "reference/plane/dynamic/dynamic_sum.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing::of_segment_past_touching_rings {
namespace {

/// At, between and beside all events within a window, the index and the dynamic sum equal the
/// static sum.
void expect_sums(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window = {}) {
  const ScaleIndex index(P, Q, window);
  DynamicSum dynamic(P, Q, window);
  const Rational hair(1, 1 << 20);
  std::vector<Rational> scales;
  Rational last = window.from.value_or(0);
  for (std::uint32_t k = 0; k < index.events(); ++k) {
    scales.push_back((last + index.event(k)) / 2);
    last = index.event(k);
    scales.insert(scales.end(), {last * (1 - hair), last, last * (1 + hair)});
  }
  scales.push_back(window.to ? Rational((last + *window.to) / 2) : Rational(last + 1));
  for (const Rational& scale : scales) {
    if ((window.from && scale < *window.from) || (window.to && scale > *window.to)) continue;
    dynamic.move_to(scale);
    const Sum expected = minkowski_sum(P, Q, scale);
    for (const Sum& found : {index.sum(scale), dynamic.sum()}) {
      EXPECT_EQ(found.region, expected.region) << to_string(scale);
      EXPECT_EQ(found.components, expected.components) << to_string(scale);
      EXPECT_EQ(found.holes, expected.holes) << to_string(scale);
    }
  }
}

TEST(SegmentPastTouchingRings, AHoleTouchesTheMiddleOfAnOuterEdge) {
  // An earlier build of this pair never ended.
  const PolygonSet P = segment_set({0, 0}, {2, 0}),
                   Q = region({{0, 7}, {-5, -3}, {1, 0}}, {{{-3, 1}, {0, 1}, {0, 0}}});
  expect_sums(P, Q);
  expect_sums(Q, P);
}

TEST(SegmentPastTouchingRings, AHoleTouchesAReflexCornerOfTheOuterRing) {
  // Once "the boundary of the swept sum jumps".
  const PolygonSet P = segment_set({0, 0}, {1, 0}),
                   Q = together(region({{3, 4}, {4, 3}, {4, 4}}),
                                region({{3, 3}, {3, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 3}},
                                       {{{3, 3}, {3, 1}, {1, 1}, {1, 3}}}));
  expect_sums(P, Q);
  expect_sums(Q, P);
}

TEST(SegmentPastTouchingRings, APassageRunsAcrossTheFaceOfASideOfAHole) {
  // Once "the boundary of the swept sum jumps"; docs/scale-index.md has the first of them.
  const PolygonSet frame =
      region(rectangle(-1, -1, 3, 3), {rectangle(0, 0, 1, 1), rectangle(1, 1, 2, 2)});
  const PolygonSet quadrangle = region({{0, 0}, {2, 1}, {3, 2}, {1, 3}}, {rectangle(1, 1, 2, 2)});
  for (const auto& [P, Q] : {std::pair{segment_set({0, 0}, {2, 1}), frame},
                             std::pair{segment_set({0, 0}, {1, -2}), quadrangle}}) {
    expect_sums(P, Q);
    expect_sums(Q, P);
  }
}

TEST(SegmentPastTouchingRings, AWindowBeginsAboveTheScaleAtWhichTheHoleIsFilled) {
  // Once "rings of the swept sum run together" and "is not closed"; without a window all was well.
  const Ring corner{{0, 0}, {4, 0}, {0, 4}};
  const PolygonSet first = segment_set({0, 0}, {1, 0}),
                   around_first = region(corner, {{{1, 2}, {1, 0}, {0, 1}}}),
                   second = segment_set({0, 0}, {2, -1}),
                   around_second = region(corner, {{{1, 1}, {1, 0}, {0, 1}}});
  expect_sums(first, around_first);
  expect_sums(first, around_first, {Rational(2), Rational(4)});
  expect_sums(second, around_second);
  expect_sums(second, around_second, {Rational(1), Rational(2)});
}

TEST(SegmentPastTouchingRings, HolesOfSeveralCellsTouch) {
  // Once "the boundary of the swept sum jumps", at 3 and at 2.
  expect_sums(segment_set({1, -1}, {2, -1}),
              region(rectangle(-1, -1, 8, 6),
                     {{{2, 4}, {3, 4}, {3, 2}, {4, 2}, {4, 1}, {1, 1}, {1, 3}, {2, 3}},
                      {{4, 3}, {6, 3}, {6, 2}, {4, 2}}}));
  expect_sums(segment_set({2, -1}, {2, 0}),
              region(rectangle(-1, -1, 7, 4), {{{0, 3},
                                                {3, 3},
                                                {3, 2},
                                                {4, 2},
                                                {4, 3},
                                                {6, 3},
                                                {6, 2},
                                                {5, 2},
                                                {5, 1},
                                                {4, 1},
                                                {4, 0},
                                                {0, 0}},
                                               {{5, 1}, {6, 1}, {6, 0}, {5, 0}}}));
}

TEST(SegmentPastTouchingRings, RegionsThatTouchFromTwoSidesInTurn) {
  // A passage at the scale 1 alone, in one point: once neither the index nor the dynamic sum closed
  // in this window.
  const Rational half(1, 2), wide(3, 2);
  const PolygonSet P = region(rectangle(-1, -2, 1, 2), {{{-1, 0}, {0, 1}, {1, 0}, {0, -1}}});
  const PolygonSet Q =
      region(rectangle(-3, -4, 3, 4),
             {{{-1, 0}, {0, Rational(-half)}, {1, 0}, {wide, -3}, {0, -2}, {Rational(-wide), -3}},
              {{1, 0}, {0, half}, {-1, 0}, {Rational(-wide), 3}, {wide, 3}}});
  expect_sums(P, Q, {Rational(63, 64), Rational(65, 64)});
  expect_sums(Q, P, {Rational(63, 64), Rational(65, 64)});
  expect_sums(P, Q, {Rational(1, 2), Rational(2)});
}

}  // namespace
}  // namespace minkref::testing::of_segment_past_touching_rings
