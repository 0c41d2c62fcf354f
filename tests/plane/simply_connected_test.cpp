// Sets cut along slits, and triangulated.
#include "reference/plane/routes/simply_connected.hpp"

#include <gtest/gtest.h>

#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_simply_connected {
namespace {

Rational own_doubled_area(const Ring& ring) {
  Rational doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    doubled += cross(ring[i], ring[(i + 1) % ring.size()]);
  }
  return doubled;
}

TEST(Triangulation, TilesTheSetWithTrianglesOfItsVertices) {
  MINKREF_SEEDED(random, 1400);
  expect_law(random, 150, [](const Case& c) -> std::string {
    std::vector<Point> vertices;
    for_each_ring(
        c.P, [&](const Ring& ring) { vertices.insert(vertices.end(), ring.begin(), ring.end()); });
    Rational doubled = 0;
    PolygonSet all;
    for (const Triangle& t : triangulate(c.P)) {
      const Rational size = cross(t[1] - t[0], t[2] - t[0]);
      if (sign(size) <= 0) return "a triangle that is not counter-clockwise";
      doubled += size;
      for (const Point& p : t) {
        if (std::find(vertices.begin(), vertices.end(), p) == vertices.end()) return "new vertex";
      }
      all.polygons.push_back({{t[0], t[1], t[2]}, {}});
    }
    if (doubled != 2 * area(c.P)) return "another area";
    // The union is the set; with equal areas, none overlap.
    return unequal(canonicalize(c.P).region, canonicalize(all).region);
  });
}

TEST(Slits, LeaveOneRingForEachComponentAndNoHoles) {
  MINKREF_SEEDED(random, 1401);
  expect_law(random, 150, [](const Case& c) -> std::string {
    const PolygonSet cut = cut_to_simply_connected(c.P);
    const Canonical form = canonicalize(c.P);
    if (cut.polygons.size() != form.components) return "a ring for each component";
    Rational doubled = 0;
    for (const Polygon& polygon : cut.polygons) {
      if (!polygon.holes.empty()) return "a hole is left";
      if (sign(own_doubled_area(polygon.outer)) <= 0) return "not counter-clockwise";
      doubled += own_doubled_area(polygon.outer);
    }
    if (doubled != 2 * area(c.P)) return "another area";
    return unequal(form.region, canonicalize(cut).region);
  });
}

TEST(Slits, RunBetweenVerticesAndInsideTheSet) {
  MINKREF_SEEDED(random, 1402);
  expect_law(random, 100, [](const Case& c) -> std::string {
    std::vector<Point> vertices;
    for_each_ring(
        c.P, [&](const Ring& ring) { vertices.insert(vertices.end(), ring.begin(), ring.end()); });
    for (const Edge& edge : edges(cut_to_simply_connected(c.P))) {
      if (std::find(vertices.begin(), vertices.end(), edge.from) == vertices.end()) {
        return "a new vertex " + text(edge.from);
      }
      for (const Rational& t : {Rational(1, 5), Rational(1, 2), Rational(10, 13)}) {
        if (where(c.P, edge.from + t * (edge.to - edge.from)) == Where::outside) {
          return "leaves the set at " + text(edge.from);
        }
      }
    }
    return "";
  });
}

TEST(Slits, PointsAndSegmentsStayAsTheyAre) {
  EXPECT_EQ(cut_to_simply_connected(point_set(1, 2)), point_set(1, 2));
  EXPECT_EQ(cut_to_simply_connected(segment_set({0, 1}, {2, 3})), segment_set({0, 1}, {2, 3}));
  EXPECT_EQ(cut_to_simply_connected({}), PolygonSet{});
}

TEST(Slits, HolesOneBehindTheOtherAndTouching) {
  // Five holes in a row: two touch each other, and one touches the outer ring.
  const PolygonSet set = region(rectangle(0, 0, 20, 6), {rectangle(1, 2, 3, 4),
                                                         {{5, 2}, {7, 3}, {5, 4}},
                                                         {{7, 3}, {9, 2}, {9, 4}},
                                                         rectangle(11, 1, 13, 5),
                                                         {{16, 0}, {17, 2}, {15, 2}}});
  ASSERT_NO_THROW(validate(set));
  const PolygonSet cut = cut_to_simply_connected(set);
  ASSERT_EQ(cut.polygons.size(), 1U);
  EXPECT_TRUE(cut.polygons[0].holes.empty());
  EXPECT_EQ(own_doubled_area(cut.polygons[0].outer), 2 * area(set));
  EXPECT_EQ(canonicalize(cut).region, canonicalize(set).region);
}

}  // namespace
}  // namespace minkref::testing::of_simply_connected
