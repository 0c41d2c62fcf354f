// A segment slides past a point at which rings of the other operand touch, the interior on either
// side of it: the closed sum covers what the sum of the interiors misses, and one edge shows it.
#include <gtest/gtest.h>

#include "reference/plane/index/scale_index.hpp"
#include "tests/plane/shapes.hpp"

namespace minkref::testing {
namespace {

/// At and between all events, and beyond them.
void expect_sums(const PolygonSet& P, const PolygonSet& Q) {
  const ScaleIndex index(P, Q, {});
  std::vector<Rational> scales;
  Rational last = 0;
  for (std::uint32_t k = 0; k < index.events(); ++k) {
    scales.push_back((last + index.event(k)) / 2);
    last = index.event(k);
    scales.push_back(last);
  }
  scales.push_back(last + 1);
  for (const Rational& scale : scales) {
    const Sum found = index.sum(scale), expected = minkowski_sum(P, Q, scale);
    EXPECT_EQ(found.region, expected.region) << to_string(scale);
    EXPECT_EQ(found.components, expected.components) << to_string(scale);
    EXPECT_EQ(found.holes, expected.holes) << to_string(scale);
  }
}

TEST(SegmentPastTouchingRings, AHoleTouchesTheMiddleOfAnOuterEdge) {
  // Once the build of this one did not end.
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

}  // namespace
}  // namespace minkref::testing
