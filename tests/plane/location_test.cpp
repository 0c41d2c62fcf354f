// Location by ray crossings against this room's own ray casting.
#include "reference/plane/location.hpp"

#include <gtest/gtest.h>

#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_location {
namespace {

bool same(Location a, Where b) {
  return (a == Location::inside) == (b == Where::inside) &&
         (a == Location::outside) == (b == Where::outside);
}

TEST(Location, AgreesWithRayCastingAtVerticesEdgesAndLevelsOfVertices) {
  MINKREF_SEEDED(random, 1300);
  Source points(random.seed() + 1);
  expect_law(random, 200, [&](const Case& c) -> std::string {
    const std::vector<Edge> all = edges(c.P);
    const auto any = [&] { return all[points.below(all.size())]; };
    const Rational tiny = Rational(1) / Rational(Integer(1) << 120);
    for (int i = 0; i < 20; ++i) {
      const Edge e = any();
      const Point on = e.from + Rational(points.between(0, 5), 5) * (e.to - e.from);
      for (const Point& x : {on, Point{any().from.x, any().from.y},
                             Point{Rational(on.x + tiny), on.y}, Point{on.x, Rational(on.y - tiny)},
                             Point{Rational(points.between(-60, 90), 7), on.y}}) {
        if (!same(locate(c.P, x), where(c.P, x))) return "at " + text(x);
      }
    }
    return "";
  });
}

TEST(Location, OfASingleRingDoesNotDependOnItsOrientation) {
  MINKREF_SEEDED(random, 1301);
  expect_law(random, 60, [](const Case& c) -> std::string {
    Ring ring = c.P.polygons[0].outer;
    const FilteredRing forward = filtered_ring(ring);
    const PolygonSet alone{{Polygon{ring, {}}}};
    std::reverse(ring.begin(), ring.end());
    const FilteredRing backward = filtered_ring(ring);
    for (int x = -20; x < 40; x += 3) {
      const Point at{Rational(x, 2), Rational(x * x % 31, 3)};
      const Location place = locate(forward, FilteredPoint(at));
      if (!same(place, where(alone, at)) || place != locate(backward, FilteredPoint(at))) {
        return "at " + text(at);
      }
    }
    return "";
  });
}

TEST(Location, WindingNumberNotParityDecidesWhereRingsOverlap) {
  const PolygonSet twice = together(box(0, 0, 2, 2), box(0, 0, 2, 2));
  EXPECT_EQ(locate(twice, {1, 1}), Location::inside);
  EXPECT_EQ(locate(PolygonSet{}, {1, 1}), Location::outside);
}

}  // namespace
}  // namespace minkref::testing::of_location
