// The law of the swept boundary: its slice at a scale equals the sum at that scale.
#include "reference/plane/index/swept_boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reference/plane/index/slice.hpp"
#include "tests/plane/index/windows.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_swept_boundary {
namespace {

/// Scales at which a piece begins or ends, and one between each two.
std::vector<Rational> telling_scales(const SweptBoundary& boundary) {
  std::set<Rational> events;
  for (const ExposedPiece& piece : boundary.pieces) {
    if (piece.lower > 0) events.insert(piece.lower);
    if (piece.upper) events.insert(*piece.upper);
  }
  std::vector<Rational> scales;
  for (const Rational& event : events) {
    if (!scales.empty()) scales.push_back((scales.back() + event) / 2);
    scales.push_back(event);
  }
  if (!boundary.window.from) scales.push_back(scales.empty() ? Rational(1) : scales.front() / 2);
  if (!boundary.window.to) scales.push_back(scales.empty() ? Rational(2) : scales.back() * 2);
  return scales;
}

std::string fault_of_slices(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window) {
  const SweptBoundary boundary = swept_boundary(P, Q, window);
  for (const Rational& scale : telling_scales(boundary)) {
    const std::string fault = fault_of_sum(P, Q, scale, slice(boundary, scale));
    if (!fault.empty()) return fault;
  }
  return "";
}

TEST(SweptBoundary, SlicesAreSumsBelowAtAndAboveEveryEvent) {
  MINKREF_SEEDED(random, 900);
  expect_law(random, 60, [](const Case& c) { return fault_of_slices(c.P, c.Q, {}); });
}

TEST(SweptBoundary, SlicesOfAWindowAreSums) {
  MINKREF_SEEDED(random, 901);
  expect_law(random, 60,
             [](const Case& c) { return fault_of_slices(c.P, c.Q, {c.scale / 2, c.scale * 2}); });
}

TEST(SweptBoundary, OfAPointOrASegmentIsThatOfTheOtherOperand) {
  MINKREF_SEEDED(random, 902);
  expect_law(random, 30, [](const Case& c) -> std::string {
    for (const PolygonSet& small : {point_set(3, -1), segment_set({0, 0}, {2, 5})}) {
      const std::string wrong = fault_of_slices(c.P, small, {}) + fault_of_slices(small, c.Q, {});
      if (!wrong.empty()) return wrong;
    }
    return "";
  });
}

TEST(SweptBoundary, OfTheEmptySetIsEmpty) {
  EXPECT_TRUE(swept_boundary({}, box(0, 0, 1, 1), {}).pieces.empty());
  EXPECT_TRUE(swept_boundary(box(0, 0, 1, 1), {}, {}).pieces.empty());
}

TEST(SweptBoundary, IsTheSameForAnyNumberOfThreads) {
  MINKREF_SEEDED(random, 903);
  expect_law(random, 30, [](const Case& c) -> std::string {
    const SweptBoundary one = swept_boundary(c.P, c.Q, {}),
                        three = swept_boundary(c.P, c.Q, {}, {3, {}, 0});
    const auto same = [](const ExposedPiece& a, const ExposedPiece& b) {
      return a.edge == b.edge && a.from == b.from && a.to == b.to && a.lower == b.lower &&
             a.upper == b.upper;
    };
    const bool all = std::equal(one.pieces.begin(), one.pieces.end(), three.pieces.begin(),
                                three.pieces.end(), same);
    return all && one.pairs_inside == three.pairs_inside ? "" : "other pieces";
  });
}

/// A hole that exists only between two scales and never touches the sum's outside: nothing on the
/// boundary at either end of the window leads to it.
TEST(SweptBoundary, HasHolesThatAreThereForAWhileOnly) {
  const PolygonSet ring = region(rectangle(0, 0, 12, 12), {rectangle(4, 4, 8, 8)});
  const PolygonSet square = box(-1, -1, 1, 1);
  const SweptBoundary boundary = swept_boundary(square, ring, {Rational(1, 2), Rational(3)});
  EXPECT_EQ(slice(boundary, 1).holes, 1U);
  EXPECT_EQ(slice(boundary, Rational(5, 2)).holes, 0U);
  EXPECT_EQ(slice(boundary, 2).holes, 0U);  // it shrinks to a point
}

}  // namespace
}  // namespace minkref::testing::of_swept_boundary
