// Numbers far beyond doubles, and numbers of unlike magnitude.
#include <gtest/gtest.h>

#include "reference/plane/point_predicates.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/witness.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_hostile_magnitude {
namespace {

const Integer huge = Integer(1) << 4000;

std::vector<Rational> magnitudes() {
  return {Rational(huge), Rational(Integer(1), huge), Rational(Integer(1) << 1023),
          Rational(Integer(1), Integer(1) << 1074), Rational((Integer(1) << 1024) - 1)};
}

TEST(HostileMagnitude, SumsAreExactBeyondTheRangeOfDoubles) {
  MINKREF_SEEDED(random, 2100);
  expect_law(random, 15, [](const Case& c) -> std::string {
    const PolygonSet sum = minkowski_sum(c.P, c.Q, c.scale).region;
    for (const Rational& m : magnitudes()) {
      for (const Route route : {Route::paper, Route::winding, Route::definition}) {
        const std::string fault =
            unequal(stretched(sum, m),
                    minkowski_sum(stretched(c.P, m), stretched(c.Q, m), c.scale, route).region);
        if (!fault.empty()) return fault;
      }
    }
    return "";
  });
}

TEST(HostileMagnitude, OneOperandHugeTheOtherTiny) {
  const Rational big(huge), small = 1 / big;
  for (const Route route : {Route::paper, Route::winding, Route::definition}) {
    EXPECT_EQ(minkowski_sum(box(0, 0, big, big), box(0, 0, small, small), 1, route).region,
              box(0, 0, big + small, big + small));
    EXPECT_EQ(minkowski_sum(box(0, 0, 1, 1), box(0, 0, small, small), big, route).region,
              box(0, 0, big + small, big + small));
    EXPECT_EQ(minkowski_sum(box(0, 0, big, 1), box(0, 0, 1, big), 1, route).region,
              box(0, 0, big + 1, big + 1));
  }
}

TEST(HostileMagnitude, AHoleSmallerThanAnyDoubleIsKeptAndClosedExactly) {
  const Rational e(Integer(1), huge);
  const PolygonSet frame = region(rectangle(0, 0, 4, 4), {rectangle(1, 1, 1 + 2 * e, 1 + 2 * e)});
  for (const Route route : {Route::paper, Route::winding, Route::definition}) {
    EXPECT_EQ(minkowski_sum(frame, box(0, 0, e, e), 1, route).holes, 1U);
    EXPECT_EQ(minkowski_sum(frame, box(0, 0, 2 * e, 2 * e), 1, route).holes, 0U);
  }
  EXPECT_EQ(decide(frame, box(0, 0, 2 * e, 2 * e), 1, {1 + 2 * e, 1 + 2 * e}).contact,
            Contact::touching);
}

TEST(HostileMagnitude, SubnormalCoordinatesBesideHugeOnes) {
  // The small coordinates differ from their nearest doubles by large parts of their size.
  const PolygonSet P = region({{0, 0},
                               {parse_rational("69e-325"), parse_rational("49e-325")},
                               {parse_rational("12e299"), parse_rational("10e299")}});
  validate(P);
  const PolygonSet square = box(0, 0, 1, 1);
  const Sum paper = minkowski_sum(P, square, 1);
  for (const Route route : {Route::winding, Route::definition}) {
    EXPECT_EQ(minkowski_sum(P, square, 1, route).region, paper.region);
  }
  EXPECT_EQ(minkowski_sum(P, point_set(0, 0), 1, Route::winding).region, canonicalize(P).region);
}

TEST(HostileMagnitude, FilteredSignsOfMixedMagnitudesAreExact) {
  MINKREF_SEEDED(random, 2101);
  const char* const magnitudes[] = {"1e-400", "1e-326", "1e-324", "1e-323", "3e-320", "1e-308",
                                    "1e-290", "1e-150", "1e-20",  "1",      "1e20",   "1e100",
                                    "1e150",  "1e290",  "1e308",  "1e309"};
  std::vector<Rational> units;
  for (const char* magnitude : magnitudes) units.push_back(parse_rational(magnitude));
  const auto number = [&] {
    return Rational(random.between(-99, 99)) * units[random.below(units.size())];
  };
  for (int i = 0; i < repetitions(20000); ++i) {
    Point p[4];
    // Half of the time the last point lies on the line of the first two, or a hair beside it.
    for (Point& point : p) point = {number(), number()};
    if (random.below(2) == 0) {
      const Rational t(random.between(-9, 9), 7);
      p[2] = {p[0].x + t * (p[1].x - p[0].x), p[0].y + t * (p[1].y - p[0].y)};
      if (random.below(2) == 0) p[2].y += units[random.below(3)];
    }
    const FilteredPoint a(p[0]), b(p[1]), c(p[2]), d(p[3]);
    const auto exact = [&](const Point& from, const Point& to) {
      return sign(
          Rational((p[1].x - p[0].x) * (to.y - from.y) - (p[1].y - p[0].y) * (to.x - from.x)));
    };
    ASSERT_EQ(orientation(a, b, c), exact(p[0], p[2])) << i;
    ASSERT_EQ(turn(a, b, c, d), exact(p[2], p[3])) << i;
    ASSERT_EQ(compare_x(a, b), sign(Rational(p[0].x - p[1].x))) << i;
  }
}

TEST(HostileMagnitude, NearlyParallelEdges) {
  // Directions that differ by one unit in 2^200: no filter with doubles can separate them.
  const Rational w(Integer(1) << 200);
  const PolygonSet P = region({{0, 0}, {w, 1}, {w, 2}}), Q = region({{0, 0}, {w + 1, 1}, {w, 3}});
  std::vector<Point> sums;
  for (const Point& p : P.polygons[0].outer) {
    for (const Point& q : Q.polygons[0].outer) sums.push_back(p + q);
  }
  for (const Route route : {Route::paper, Route::winding, Route::definition}) {
    EXPECT_EQ(text(minkowski_sum(P, Q, 1, route).region), text(region(convex_hull(sums))));
  }
}

TEST(HostileMagnitude, OtherArithmeticsAnswerOrThrowAnErrorOfOurs) {
  const PolygonSet L = region({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}});
  for (const char* name : {"double", "mpfr:53", "mpfr:256", "interval"}) {
    for (const Rational& m : magnitudes()) {
      try {
        const Sum sum = minkowski_sum(stretched(L, m), box(0, 0, 1, 1), 1, Route::paper, name);
        EXPECT_LE(sum.holes, 10U);
      } catch (const Error&) {
        SUCCEED();
      }
    }
  }
}

}  // namespace
}  // namespace minkref::testing::of_hostile_magnitude
