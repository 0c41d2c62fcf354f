// Unions, intersections and differences: laws of sets, and points by casting rays.
#include "reference/plane/boundary/set_operations.hpp"

#include <gtest/gtest.h>

#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_set_operations {
namespace {

PolygonSet united(const std::vector<PolygonSet>& sets) {
  return combined(SetOperation::unite, sets).region;
}
PolygonSet common(const std::vector<PolygonSet>& sets) {
  return combined(SetOperation::intersect, sets).region;
}
PolygonSet without(const PolygonSet& first, const PolygonSet& second) {
  return combined(SetOperation::subtract, {first, second}).region;
}

std::string wrong_area(const PolygonSet& P, const PolygonSet& Q) {
  const Rational whole = area(united({P, Q})), shared = area(common({P, Q}));
  if (whole + shared != area(P) + area(Q)) return "inclusion and exclusion";
  if (area(without(P, Q)) + shared != area(P)) return "the difference and what is shared";
  return "";
}

std::string wrong_law(const PolygonSet& P, const PolygonSet& Q) {
  const PolygonSet p = canonicalize(P).region;
  if (united({P, Q}) != united({Q, P}) || common({P, Q}) != common({Q, P})) return "commutativity";
  if (united({without(P, Q), common({P, Q})}) != p) return "a set is its two parts";
  if (united({P, P}) != p || common({P, P}) != p || !without(P, P).empty()) return "idempotence";
  if (without(united({P, Q}), Q) != without(P, Q)) return "union less the second";
  if (!common({without(P, Q), Q}).empty()) return "the difference meets the second";
  if (common({P, united({P, Q})}) != p) return "absorption";
  return "";
}

TEST(SetOperations, AreasAddUpAndLawsOfSetsHold) {
  MINKREF_SEEDED(random, 810);
  expect_law(random, 100, [](const Case& c) {
    const std::string wrong = wrong_area(c.P, c.Q);
    return wrong.empty() ? wrong_law(c.P, c.Q) : wrong;
  });
}

TEST(SetOperations, PointsAreWhereTheirSetsSay) {
  MINKREF_SEEDED(random, 811);
  std::size_t inside = 0;
  expect_law(random, 60, [&](const Case& c) -> std::string {
    const PolygonSet all = united({c.P, c.Q}), both = common({c.P, c.Q}), less = without(c.P, c.Q);
    for (int k = 0; k < 40; ++k) {
      const Point x{Rational(random.between(-40, 40), 7), Rational(random.between(-40, 40), 9)};
      const Where p = where(c.P, x), q = where(c.Q, x);
      if (p == Where::boundary || q == Where::boundary) continue;
      const bool in_P = p == Where::inside, in_Q = q == Where::inside;
      const auto is = [&](const PolygonSet& set) { return where(set, x) == Where::inside; };
      if (is(all) != (in_P || in_Q)) return "union at " + text(x);
      if (is(both) != (in_P && in_Q)) return "intersection at " + text(x);
      if (is(less) != (in_P && !in_Q)) return "difference at " + text(x);
      inside += is(both) ? 1 : 0;
    }
    return "";
  });
  EXPECT_GT(inside, 0U);
}

TEST(SetOperations, OfThreeSetsIsTheSameInTwoSteps) {
  MINKREF_SEEDED(random, 812);
  expect_law(random, 60, [](const Case& c) -> std::string {
    const PolygonSet third = box(-1, 0, 2, 1);
    if (united({c.P, c.Q, third}) != united({united({c.P, c.Q}), third})) return "union";
    if (common({c.P, c.Q, third}) != common({common({c.P, c.Q}), third})) return "intersection";
    const PolygonSet at_once = combined(SetOperation::subtract, {c.P, c.Q, third}).region;
    return at_once == without(without(c.P, c.Q), third) ? "" : "difference";
  });
}

TEST(SetOperations, TouchingSetsBecomeOneWhereTheyShareAnEdge) {
  const PolygonSet left = box(0, 0, 1, 1), right = box(1, 0, 2, 1), corner = box(1, 1, 2, 2);
  EXPECT_EQ(united({left, right}), canonicalize(box(0, 0, 2, 1)).region);
  EXPECT_EQ(combined(SetOperation::unite, {left, corner}).components, 2U);
  EXPECT_TRUE(common({left, right}).empty());
  EXPECT_EQ(without(left, right), canonicalize(left).region);
}

TEST(SetOperations, WithoutInteriorNothingIsAdded) {
  const PolygonSet square = box(0, 0, 1, 1), point{{{{{5, 5}}, {}}}};
  EXPECT_EQ(united({square, point}), canonicalize(square).region);
  EXPECT_EQ(without(square, point), canonicalize(square).region);
  EXPECT_TRUE(common({square, point}).empty());
  EXPECT_TRUE(united({}).empty());
  EXPECT_TRUE(united({PolygonSet{}, PolygonSet{}}).empty());
  EXPECT_TRUE(without(PolygonSet{}, square).empty());
}

TEST(SetOperations, UnionsOfManySlidersAreExact) {
  const Rational e = Rational(1) / Rational(Integer(1) << 200);
  std::vector<PolygonSet> slivers;
  for (int k = 0; k < 50; ++k) slivers.push_back(box(k, 0, k + 1 + (k % 2 == 0 ? e : -e), 1));
  const Canonical found = combined(SetOperation::unite, slivers);
  EXPECT_EQ(found.components, 25U);  // each second gap is as wide as e
  EXPECT_EQ(area(found.region), Rational(50) - 24 * e - e);
}

Rational filled_area(const Ring& ring, FillRule rule) {
  return area(filled({{Polygon{ring, {}}}}, rule).region);
}

TEST(SetOperations, ARuleTellsWhatLiesInARingThatCrossesItself) {
  // A bow tie of two triangles with the areas 4 and 1, the smaller one wound the other way.
  const Ring bow{{0, 0}, {4, 0}, {1, 3}, {3, 3}};
  EXPECT_EQ(filled_area(bow, FillRule::nonzero), 5);
  EXPECT_EQ(filled_area(bow, FillRule::evenodd), 5);
  EXPECT_EQ(filled_area(bow, FillRule::positive), 4);
  EXPECT_FALSE(filled({{Polygon{bow, {}}}}, FillRule::nonzero).well_formed);
  // Around a square of the area 4, then around one of the area 1 in it: twice.
  const Ring twice{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(filled_area(twice, FillRule::nonzero), 4);
  EXPECT_EQ(filled_area(twice, FillRule::evenodd), 3);
  EXPECT_EQ(filled_area(twice, FillRule::positive), 4);
  // Clockwise, nothing is positive.
  const Ring clockwise{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
  EXPECT_EQ(filled_area(clockwise, FillRule::nonzero), 1);
  EXPECT_EQ(filled_area(clockwise, FillRule::evenodd), 1);
  EXPECT_EQ(filled_area(clockwise, FillRule::positive), 0);
  EXPECT_TRUE(filled({}, FillRule::nonzero).region.empty());
}

}  // namespace
}  // namespace minkref::testing::of_set_operations
