// The overlap filter: certain answers hold, even with coarse doubles.
#include "reference/plane/overlap_filter.hpp"

#include <gtest/gtest.h>

#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_polygons.hpp"

namespace minkref::testing::of_overlap_filter {
namespace {

NearTriangle near(const PolygonSet& triangle) {
  std::vector<FilteredPoint> points;
  for (const Point& p : triangle.polygons[0].outer) points.emplace_back(p);
  return NearTriangle(points);
}

bool certain(const PolygonSet& a, const PolygonSet& b, const Point& x) {
  return certainly_overlap(near(a), near(b), FilteredPoint(x));
}

PolygonSet random_triangle(Source& random) {
  for (;;) {
    const auto point = [&] { return Point{random.between(-4, 4), random.between(-4, 4)}; };
    PolygonSet set = region({point(), point(), point()});
    if (is_valid(set)) return set;
  }
}

TEST(OverlapFilter, FindsAllOverlapsOfSmallTrianglesAndNoOthers) {
  MINKREF_SEEDED(random, 720);
  int overlaps = 0, touches = 0;
  for (int i = 0; i < 3000; ++i) {
    const PolygonSet a = random_triangle(random), b = random_triangle(random);
    const Point x{random.between(-8, 8), random.between(-8, 8)};
    const Contact truth = contact_at(a, b, 1, x);
    EXPECT_EQ(certain(a, b, x), truth == Contact::overlapping) << text(a) << text(b) << text(x);
    overlaps += truth == Contact::overlapping;
    touches += truth == Contact::touching;
  }
  EXPECT_GT(overlaps, 200);
  EXPECT_GT(touches, 100);
}

TEST(OverlapFilter, IsNeverCertainOfTrianglesThatOnlyTouchNextToThemInDoubles) {
  // Stretches, turns and moves a touching pair by fractions that doubles round: it still touches.
  MINKREF_SEEDED(random, 721);
  int tried = 0;
  while (tried < 300) {
    const PolygonSet a = random_triangle(random), b = random_triangle(random);
    const Point x{random.between(-8, 8), random.between(-8, 8)};
    if (contact_at(a, b, 1, x) != Contact::touching) continue;
    ++tried;
    const Rational c = random.rational(9) + Rational(1, 3), d = random.rational(9) + Rational(1, 7);
    const Point by{Rational(random.between(-99, 99), 7) * Rational(Integer(1) << 20),
                   Rational(random.between(-99, 99), 11)};
    const auto map = [&](const Point& p) -> Point {
      return {Rational(c * p.x - d * p.y), Rational(d * p.x + c * p.y)};
    };
    const PolygonSet first = shifted(mapped(a, map), by), second = mapped(b, map);
    const Point at = map(x) + by;
    ASSERT_EQ(contact_at(first, second, 1, at), Contact::touching);
    EXPECT_FALSE(certain(first, second, at)) << text(first) << text(second) << text(at);
  }
}

TEST(OverlapFilter, SaysNothingWhereProductsOfDoublesOverflowOrVanish) {
  const PolygonSet triangle = region({{0, 0}, {2, 0}, {0, 2}});
  for (const Rational& factor :
       {Rational(Integer(1) << 600), Rational(Integer(1) << 1100),
        Rational(Integer(1), Integer(1) << 600), Rational(Integer(1), Integer(1) << 1100)}) {
    const PolygonSet set = stretched(triangle, factor);
    EXPECT_FALSE(certain(set, set, {factor, factor}));
    EXPECT_EQ(Membership(set, set, 1).contact({factor, factor}), Contact::overlapping);
  }
}

}  // namespace
}  // namespace minkref::testing::of_overlap_filter
