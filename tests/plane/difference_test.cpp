// The point that proves two sets different.
#include <gtest/gtest.h>

#include "reference/plane/witness.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_difference {
namespace {

TEST(Difference, OfEqualSetsIsNone) {
  MINKREF_SEEDED(random, 800);
  expect_law(random, 100, [](const Case& c) {
    return difference(c.P, canonicalize(c.P).region) || difference(c.P, c.P) ? "differs" : "";
  });
}

TEST(Difference, LiesInTheInteriorOfOneAndOutsideTheOther) {
  MINKREF_SEEDED(random, 801);
  expect_law(random, 150, [](const Case& c) -> std::string {
    const std::optional<Difference> found = difference(c.P, c.Q);
    if (!found) return canonicalize(c.P).region == canonicalize(c.Q).region ? "" : "none found";
    const Where p = where(c.P, found->point), q = where(c.Q, found->point);
    const Where holder = found->in_first ? p : q, other = found->in_first ? q : p;
    return holder == Where::inside && other == Where::outside ? "" : "at " + text(found->point);
  });
}

TEST(Difference, FindsATinyHole) {
  const Rational e = Rational(1) / Rational(Integer(1) << 300);
  const PolygonSet full = box(0, 0, 4, 4);
  const PolygonSet pierced = region(rectangle(0, 0, 4, 4), {{{1, 1}, {1 + e, 1}, {1, 1 + e}}});
  const std::optional<Difference> found = difference(full, pierced);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->in_first);
  EXPECT_EQ(where(full, found->point), Where::inside);
  EXPECT_EQ(where(pierced, found->point), Where::outside);
}

TEST(Difference, FindsAMissingPolygonAndTheEmptySet) {
  const PolygonSet one = box(0, 0, 1, 1), two = together(one, box(5, 5, 6, 6));
  const std::optional<Difference> lost = difference(one, two);
  ASSERT_TRUE(lost.has_value());
  EXPECT_FALSE(lost->in_first);
  EXPECT_EQ(where(box(5, 5, 6, 6), lost->point), Where::inside);
  ASSERT_TRUE(difference(one, {}).has_value());
  EXPECT_TRUE(difference(one, {})->in_first);
  EXPECT_FALSE(difference({}, {}).has_value());
}

TEST(Difference, IsOfFewDigits) {
  // [0,1]^2 and [0,1]x[0,2]: any point will do; the test asks for few digits.
  const std::optional<Difference> found = difference(box(0, 0, 1, 1), box(0, 0, 1, 2));
  ASSERT_TRUE(found.has_value());
  EXPECT_LE(to_string(found->point.x).size(), 5U);
  EXPECT_LE(to_string(found->point.y).size(), 5U);
}

}  // namespace
}  // namespace minkref::testing::of_difference
