// Sets that are not regular closed, or not rightly given: each refusal names ring and vertices.
#include <gtest/gtest.h>

#include <set>

#include "reference/error.hpp"
#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_refused {
namespace {

using Indices = std::vector<std::size_t>;

/// No `orient`: rings as written.
PolygonSet raw(Ring outer, std::vector<Ring> holes = {}) {
  return {{Polygon{std::move(outer), std::move(holes)}}};
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

struct Refusal {
  std::string code;
  std::optional<std::size_t> ring, other_ring;
  Indices vertices, other_vertices;
};

Refusal refusal(const PolygonSet& set) {
  try {
    validate(set);
  } catch (const BadInput& e) {
    EXPECT_FALSE(e.problem().empty());
    EXPECT_FALSE(e.mend().empty());
    EXPECT_NE(std::string(e.what()).find(e.problem()), std::string::npos);
    EXPECT_NE(std::string(e.what()).find(e.mend()), std::string::npos);
    // The coordinates are exact vertex coordinates.
    std::vector<Ring> rings;
    for_each_ring(set, [&](const Ring& ring) { rings.push_back(ring); });
    const Place& place = e.place();
    std::vector<std::string> expected;
    if (place.ring) {
      for (const std::size_t v : place.vertices) {
        const Point& p = rings.at(*place.ring).at(v);
        expected.push_back("(" + to_string(p.x) + ", " + to_string(p.y) + ")");
      }
    }
    EXPECT_FALSE(expected.empty() && !place.vertices.empty());
    for (const std::string& point : expected) {
      EXPECT_NE(std::find(place.coordinates.begin(), place.coordinates.end(), point),
                place.coordinates.end())
          << point;
      EXPECT_NE(std::string(e.what()).find(point), std::string::npos) << e.what();
    }
    return {e.code(), place.ring, place.other_ring, place.vertices, place.other_vertices};
  }
  ADD_FAILURE() << "accepted: " << text(set);
  return {};
}

void expect_refused(const PolygonSet& set, const std::string& code, std::size_t ring,
                    const Indices& vertices) {
  const Refusal found = refusal(set);
  EXPECT_EQ(found.code, code) << text(set);
  EXPECT_EQ(found.ring, ring) << text(set);
  EXPECT_EQ(found.vertices, vertices) << text(set);
}

void expect_pair_refused(const PolygonSet& set, const std::string& code, std::size_t ring,
                         std::size_t other) {
  const Refusal found = refusal(set);
  EXPECT_EQ(found.code, code) << text(set);
  ASSERT_TRUE(found.ring && found.other_ring) << text(set);
  EXPECT_EQ(std::minmax(*found.ring, *found.other_ring), std::minmax(ring, other)) << text(set);
}

TEST(Refused, TooFewVertices) {
  // One or two vertices form a point or a segment only if the set has no others.
  EXPECT_EQ(refusal(raw({})).code, "too-few-vertices");
  const Refusal with_region = refusal(together(box(0, 0, 1, 1), segment_set({5, 5}, {6, 6})));
  EXPECT_EQ(with_region.code, "too-few-vertices");
  EXPECT_EQ(with_region.ring, 1U);
  const Refusal hole = refusal(raw(rectangle(0, 0, 4, 4), {{{1, 1}, {2, 2}}}));
  EXPECT_EQ(hole.code, "too-few-vertices");
  EXPECT_EQ(hole.ring, 1U);
  EXPECT_EQ(refusal(raw(rectangle(0, 0, 4, 4), {{}})).ring, 1U);
  EXPECT_EQ(refusal(together(point_set(0, 0), point_set(1, 1))).code, "open-lines");
  EXPECT_EQ(refusal(raw({{0, 0}, {1, 0}}, {{{0, 0}, {0, 1}, {1, 1}}})).code, "too-few-vertices");
}

TEST(Refused, ZeroLengthEdge) {
  expect_refused(raw({{0, 0}, {4, 0}, {4, 0}, {0, 4}}), "zero-length-edge", 0, {1, 2});
  expect_refused(raw({{0, 0}, {4, 0}, {0, 4}, {0, 0}}), "zero-length-edge", 0, {3, 0});
  expect_refused(raw(rectangle(0, 0, 9, 9), {{{1, 1}, {1, 3}, {1, 3}, {3, 1}}}), "zero-length-edge",
                 1, {1, 2});
  EXPECT_EQ(refusal(segment_set({1, 2}, {1, 2})).code, "zero-length-edge");
}

TEST(Refused, ZeroArea) {
  EXPECT_EQ(refusal(raw({{0, 0}, {2, 2}, {4, 4}})).code, "zero-area");
  EXPECT_EQ(refusal(raw({{0, 0}, {2, 2}, {4, 4}})).ring, 0U);
  const Refusal hole = refusal(raw(rectangle(0, 0, 9, 9), {{{1, 1}, {2, 2}, {3, 3}}}));
  EXPECT_EQ(hole.code, "zero-area");
  EXPECT_EQ(hole.ring, 1U);
}

TEST(Refused, WrongOrientation) {
  EXPECT_EQ(refusal(raw(reversed(rectangle(0, 0, 1, 1)))).code, "wrong-orientation");
  EXPECT_EQ(refusal(raw(reversed(rectangle(0, 0, 1, 1)))).ring, 0U);
  const Refusal hole = refusal(raw(rectangle(0, 0, 9, 9), {rectangle(1, 1, 2, 2)}));
  EXPECT_EQ(hole.code, "wrong-orientation");
  EXPECT_EQ(hole.ring, 1U);
  // Rings are numbered outer, holes, outer, holes, ...
  PolygonSet two = region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 2, 2)});
  two.polygons.push_back({reversed(rectangle(20, 0, 21, 1)), {}});
  EXPECT_EQ(refusal(two).ring, 2U);
}

TEST(Refused, SelfIntersectionNamesTheTwoEdges) {
  // A ring that crosses itself in the middle, with nonzero area.
  const Ring bow{{0, 0}, {4, 0}, {1, 3}, {3, 3}};
  const Refusal found = refusal(raw(bow));
  EXPECT_EQ(found.code, "self-intersection");
  EXPECT_EQ(found.ring, 0U);
  // Edges 1-2 and 3-0 cross.
  const std::set<std::size_t> named(found.vertices.begin(), found.vertices.end()),
      also(found.other_vertices.begin(), found.other_vertices.end());
  std::set<std::size_t> all = named;
  all.insert(also.begin(), also.end());
  EXPECT_EQ(all, (std::set<std::size_t>{0, 1, 2, 3}));
}

TEST(Refused, ARingThatCrossesItselfEverywhereIsRefusedWithoutALookAtAllPairs) {
  // Some 20,000 million pairs of edges with boxes that overlap: a look at all takes a minute.
  Ring ring;
  for (long k = 0; k < 200'000; ++k) ring.push_back({k * 7919 % 1'048'583, k * 611'953 % 999'983});
  const Refusal found = refusal(raw(std::move(ring)));
  EXPECT_EQ(found.code, "self-intersection");
  ASSERT_EQ(found.vertices.size(), 4U);
  EXPECT_EQ(found.vertices[0], 0U);  // the first fault in the order of the ring
}

TEST(Refused, RingsThatTouchThemselves) {
  // A vertex twice, a vertex on an edge, an edge back along another, an antenna.
  for (const Ring& ring :
       {Ring{{0, 0}, {4, 0}, {4, 4}, {2, 2}, {1, 4}, {0, 4}, {2, 2}},
        Ring{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}},
        Ring{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 6}, {2, 4}, {0, 4}},
        Ring{{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}}, Ring{{0, 0}, {6, 0}, {2, 0}, {2, 3}}}) {
    PolygonSet set = raw(ring);
    orient(set);
    const Refusal found = refusal(set);
    EXPECT_EQ(found.code, "self-intersection") << text(set);
    EXPECT_EQ(found.ring, 0U);
    EXPECT_FALSE(found.vertices.empty());
  }
}

TEST(Refused, SelfIntersectionOfAHoleNamesTheHole) {
  PolygonSet set =
      raw(rectangle(-9, -9, 9, 9), {rectangle(-5, -5, -4, -4), {{0, 0}, {4, 0}, {1, 3}, {3, 3}}});
  orient(set);
  const Refusal found = refusal(set);
  EXPECT_EQ(found.code, "self-intersection");
  EXPECT_EQ(found.ring, 2U);
}

TEST(Refused, OverlappingRings) {
  // A hole that shares part of an edge with its outer ring, holes that share one, polygons that
  // share one, and the same ring twice.
  expect_pair_refused(region(rectangle(0, 0, 9, 9), {rectangle(0, 3, 2, 5)}), "overlapping-rings",
                      0, 1);
  expect_pair_refused(region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 3, 3), rectangle(3, 2, 5, 4)}),
                      "overlapping-rings", 1, 2);
  expect_pair_refused(together(box(0, 0, 1, 1), box(1, 0, 2, 1)), "overlapping-rings", 0, 1);
  expect_pair_refused(region(rectangle(0, 0, 9, 9), {rectangle(0, 0, 9, 9)}), "overlapping-rings",
                      0, 1);
  expect_pair_refused(
      together(region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 8, 8)}), box(1, 1, 8, 8)),
      "overlapping-rings", 1, 2);
}

TEST(Refused, CrossingRings) {
  expect_pair_refused(region(rectangle(0, 0, 9, 9), {rectangle(-1, 3, 2, 5)}), "crossing-rings", 0,
                      1);
  expect_pair_refused(region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 4, 4), rectangle(3, 3, 6, 6)}),
                      "crossing-rings", 1, 2);
  expect_pair_refused(together(box(0, 0, 2, 2), box(1, 1, 3, 3)), "crossing-rings", 0, 1);
}

TEST(Refused, RingsThatCrossAtVertices) {
  // In and out at two vertices of the other ring: no edge crosses another edge's interior.
  expect_pair_refused(together(box(0, 0, 4, 4), region({{0, 0}, {4, 4}, {-1, 5}})),
                      "crossing-rings", 0, 1);
  // A diamond through the four corners of a square, its own corners outside.
  const Refusal found =
      refusal(together(box(-2, -2, 2, 2), region({{0, -4}, {4, 0}, {0, 4}, {-4, 0}})));
  EXPECT_TRUE(found.code == "overlapping-polygons" || found.code == "crossing-rings") << found.code;
}

TEST(Refused, HoleOutside) {
  const Refusal apart = refusal(region(rectangle(0, 0, 2, 2), {rectangle(5, 5, 6, 6)}));
  EXPECT_EQ(apart.code, "hole-outside");
  EXPECT_EQ(apart.ring, 1U);
  // Outside, touching at a point.
  EXPECT_EQ(refusal(region(rectangle(0, 0, 2, 2), {rectangle(2, 2, 3, 3)})).code, "hole-outside");
  // Around its own outer ring.
  EXPECT_EQ(refusal(region(rectangle(0, 0, 2, 2), {rectangle(-5, -5, 6, 6)})).code, "hole-outside");
  // In another polygon.
  PolygonSet two = together(box(0, 0, 2, 2), box(10, 0, 19, 9));
  two.polygons[0].holes.push_back(reversed(rectangle(12, 2, 14, 4)));
  EXPECT_EQ(refusal(two).ring, 1U);
  EXPECT_EQ(refusal(two).code, "hole-outside");
}

TEST(Refused, HoleInAHole) {
  const Refusal found =
      refusal(region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 8, 8), rectangle(3, 3, 5, 5)}));
  EXPECT_TRUE(found.code == "hole-outside" || found.code == "overlapping-rings") << found.code;
}

TEST(Refused, OverlappingPolygons) {
  expect_pair_refused(together(box(0, 0, 9, 9), box(2, 2, 3, 3)), "overlapping-polygons", 0, 1);
  expect_pair_refused(together(box(2, 2, 3, 3), box(0, 0, 9, 9)), "overlapping-polygons", 0, 1);
  // The inner square's corners lie on the outer square's edges.
  expect_pair_refused(together(box(0, 0, 4, 4), region({{2, 0}, {4, 2}, {2, 4}, {0, 2}})),
                      "overlapping-polygons", 0, 1);
  // Inside a polygon with a hole, beside the hole.
  expect_pair_refused(
      together(region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 3, 3)}), box(5, 5, 6, 6)),
      "overlapping-polygons", 0, 2);
  // One polygon's hole lies inside the other polygon, which lies inside the first's outer ring and
  // covers the hole.
  EXPECT_EQ(
      refusal(together(region(rectangle(0, 0, 9, 9), {rectangle(4, 4, 5, 5)}), box(3, 3, 6, 6)))
          .code,
      "overlapping-polygons");
}

TEST(Refused, SourceIsFilledInWhereItIsEmpty) {
  try {
    validate(raw(reversed(rectangle(0, 0, 1, 1))));
    FAIL();
  } catch (const BadInput& e) {
    const BadInput named = e.from("file.wkt");
    EXPECT_EQ(named.place().source, "file.wkt");
    EXPECT_EQ(named.from("other").place().source, "file.wkt");
    EXPECT_EQ(named.code(), e.code());
    EXPECT_NE(std::string(named.what()).find("file.wkt"), std::string::npos);
  }
}

TEST(Refused, RandomOverlapsOfTwoRegionsAreRefusedAndOnlyThose) {
  // Two regions given together are an operand iff their interiors are disjoint and their
  // boundaries meet in points only.
  MINKREF_SEEDED(random, 1800);
  int refused = 0, accepted = 0;
  for (int i = 0; i < repetitions(300); ++i) {
    const PolygonSet a = random_mesh_region(random, 2);
    const PolygonSet b =
        shifted(random_mesh_region(random, 2), {random.between(-4, 8), random.between(-4, 8)});
    bool apart = true;
    for (const Edge& e : edges(a)) {
      for (const Edge& f : edges(b)) apart = apart && meeting(e, f).size() < 2;
    }
    apart = apart && contact_by_edges(a, b) != Contact::overlapping;
    (apart ? accepted : refused) += 1;
    ASSERT_EQ(is_valid(together(a, b)), apart) << text(together(a, b));
  }
  EXPECT_GE(refused, testing::repetitions(20));
  EXPECT_GT(accepted, 20);
}

}  // namespace
}  // namespace minkref::testing::of_refused
