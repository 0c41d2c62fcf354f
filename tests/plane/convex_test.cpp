// Convex operands: the sum is the convex hull of their vertex sums.
#include <gtest/gtest.h>

#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_convex {
namespace {

std::string not_the_hull(const Case& c) {
  std::vector<Point> sums;
  for (const Point& p : c.P.polygons[0].outer) {
    for (const Point& q : c.Q.polygons[0].outer) sums.push_back(c.scale * p + q);
  }
  const PolygonSet hull = region(convex_hull(sums));
  for (const Route route : {Route::paper, Route::winding, Route::definition}) {
    const Sum sum = minkowski_sum(c.P, c.Q, c.scale, route);
    if (sum.components != 1 || sum.holes != 0) return "one component without holes";
    if (sum.region != hull) return unequal(hull, sum.region);
  }
  return "";
}

TEST(ConvexOperands, SumIsTheHullOfTheSumsOfVertices) {
  MINKREF_SEEDED(random, 600);
  const auto make = [](Source& r) {
    return Case{random_convex_polygon(r, r.between(3, 12)), random_convex_polygon(r),
                random_scale(r)};
  };
  expect_law(random, 200, make, not_the_hull);
}

TEST(ConvexOperands, ManyParallelEdges) {
  MINKREF_SEEDED(random, 601);
  expect_law(random, 200, convex_polygons(9, 2), not_the_hull);
}

TEST(ConvexOperands, StraightVerticesInParallelEdges) {
  MINKREF_SEEDED(random, 602);
  const auto with_straight = [](PolygonSet set) {
    Ring finer;
    const Ring& ring = set.polygons[0].outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      finer.push_back(ring[i]);
      finer.push_back(midpoint(ring[i], ring[(i + 1) % ring.size()]));
    }
    set.polygons[0].outer = finer;
    return set;
  };
  const auto make = [&](Source& r) {
    const PolygonSet P = random_convex_polygon(r, 8, 2), Q = random_convex_polygon(r, 8, 2);
    return Case{r.coin() ? with_straight(P) : P, with_straight(Q), random_scale(r)};
  };
  expect_law(random, 100, make, not_the_hull);
}

TEST(ConvexOperands, AreaIsThatOfTheMixedVolumes) {
  // |sP + Q| = s^2 |P| + 2 s V(P, Q) + |Q|: three scales determine V, a fourth must agree.
  MINKREF_SEEDED(random, 603);
  expect_law(random, 50, convex_polygons(), [](const Case& c) -> std::string {
    const auto mixed = [&](const Rational& s) {
      return Rational((area(minkowski_sum(c.P, c.Q, s)) - s * s * area(c.P) - area(c.Q)) / s);
    };
    return mixed(1) == mixed(Rational(7, 3)) && mixed(1) == mixed(c.scale) ? "" : "not quadratic";
  });
}

}  // namespace
}  // namespace minkref::testing::of_convex
