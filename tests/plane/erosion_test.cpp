// Erosion, opening, closing: laws, exact fits, and outsides as operands.
#include "reference/plane/erosion/erosion.hpp"

#include <gtest/gtest.h>

#include "reference/error.hpp"
#include "reference/plane/boundary/set_operations.hpp"
#include "reference/plane/erosion/outside.hpp"
#include "reference/plane/location.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_erosion {
namespace {

/// P so large that Q has room, or just has.
Case with_room(Source& random) {
  for (;;) {
    Case c{random_region(random, 2), random_region(random), 1};
    const auto least = least_scale_with_room(c.P, c.Q);
    c.scale = *least * Rational(static_cast<long>(random.between(2, 8)), 2);
    if (c.P.vertices() * c.Q.vertices() < 400) return c;
  }
}

bool within(const PolygonSet& inner, const PolygonSet& outer) {
  return combined(SetOperation::subtract, {inner, outer}).region.empty();
}

std::vector<Point> points_of(const Sum& eroded) {
  std::vector<Point> points;
  for (const TightPassage& remnant : *eroded.tight_passages) {
    points.insert(points.end(), remnant.points.begin(), remnant.points.end());
  }
  return points;
}

TEST(Erosion, RoutesAgree) {
  MINKREF_SEEDED(random, 3301);
  expect_law(random, 25, with_room, [](const Case& c) -> std::string {
    const Sum paper = erosion(c.P, c.Q, c.scale);
    for (const Route route : {Route::winding, Route::definition}) {
      const Sum other = erosion(c.P, c.Q, c.scale, route);
      if (other.region != paper.region || other.holes != paper.holes) return "another set";
      if (*other.tight_passages != *paper.tight_passages) return "other remnants";
    }
    return "";
  });
}

TEST(Erosion, UndoesASum) {
  MINKREF_SEEDED(random, 3302);
  expect_law(random, 40, [](const Case& c) -> std::string {
    const PolygonSet sum = minkowski_sum(c.P, c.Q, c.scale).region;
    const Sum closed = closing(c.P, c.Q, c.scale);
    if (closed.region != erosion(sum, c.Q, 1).region) return "closing";
    if (!within(scaled(c.P, c.scale), closed.region)) return "the closing misses a part of P";
    const PolygonSet again = minkowski_sum(closed.region, c.Q, 1).region;
    return unequal(sum, again);
  });
}

TEST(Erosion, OpeningLiesWithinAndIsIdempotent) {
  MINKREF_SEEDED(random, 3303);
  std::size_t not_empty = 0;
  expect_law(random, 30, with_room, [&](const Case& c) -> std::string {
    const PolygonSet opened = opening(c.P, c.Q, c.scale).region;
    not_empty += opened.empty() ? 0 : 1;
    if (!within(opened, scaled(c.P, c.scale))) return "outside of P";
    return unequal(opened, opening(opened, c.Q, 1).region);
  });
  EXPECT_GT(not_empty, 5U);
}

TEST(Erosion, ByASumIsErosionTwice) {
  MINKREF_SEEDED(random, 3304);
  expect_law(random, 25, with_room, [](const Case& c) -> std::string {
    const PolygonSet small = scaled(c.Q, Rational(1, 3));
    const Sum once = erosion(c.P, c.Q, c.scale);
    if (!once.tight_passages->empty()) return "";
    const Sum twice = erosion(once.region, small, 1);
    const Sum both = erosion(c.P, minkowski_sum(c.Q, small, 1).region, c.scale);
    if (points_of(twice) != points_of(both)) return "other remnants";
    return unequal(both.region, twice.region);
  });
}

TEST(Erosion, IsTranslationCovariantAndHomogeneous) {
  MINKREF_SEEDED(random, 3305);
  expect_law(random, 25, with_room, [](const Case& c) -> std::string {
    const Point p{Rational(7, 3), -5}, q{2, Rational(1, 9)};
    const PolygonSet P = scaled(c.P, c.scale);
    const Sum here = erosion(P, c.Q, 1), there = erosion(shifted(P, p), shifted(c.Q, q), 1);
    const PolygonSet moved = shifted(here.region, {p.x - q.x, p.y - q.y});
    if (there.region != canonicalize(moved).region) return "translation";
    const Sum large = erosion(stretched(P, 3), stretched(c.Q, 3), 1);
    return unequal(large.region, stretched(here.region, 3));
  });
}

TEST(Erosion, RemnantsLieOnTheirContacts) {
  // A contact names an edge of P and a vertex of -Q, or a vertex of P and an edge of -Q.
  const PolygonSet P = region(rectangle(0, 0, 9, 9), {rectangle(3, 3, 5, 5)});
  const PolygonSet Q = box(1, 1, 4, 4);
  const Sum eroded = erosion(P, Q, 1);
  ASSERT_EQ(eroded.components, 1U);
  ASSERT_EQ(eroded.tight_passages->size(), 1U);
  EXPECT_EQ((*eroded.tight_passages)[0].points, (std::vector<Point>{{-1, 4}, {-1, -1}, {4, -1}}));
  const PolygonSet mine = negated(Q);
  std::vector<Ring> rings;
  for_each_ring(P, [&](const Ring& ring) { rings.push_back(ring); });
  std::size_t seen = 0;
  for (const TightPassage& remnant : *eroded.tight_passages) {
    for (std::size_t i = 0; i < remnant.contacts.size(); ++i) {
      for (const ConvolutionEdge& contact : remnant.contacts[i]) {
        const bool of_P = contact.kind == ConvolutionEdge::Kind::S;
        const Ring& edges = of_P ? rings.at(contact.edge.ring) : mine.polygons[0].outer;
        const Ring& corners = of_P ? mine.polygons[0].outer : rings.at(contact.vertex.ring);
        const Point a = edges.at(contact.edge.index);
        const Point b = edges.at((contact.edge.index + 1) % edges.size());
        const Point v = corners.at(contact.vertex.index);
        const Point& x = remnant.points[i];
        EXPECT_EQ((b.x - a.x) * (x.y - v.y - a.y), (b.y - a.y) * (x.x - v.x - a.x));
        ++seen;
      }
    }
  }
  EXPECT_GE(seen, 4U);
}

TEST(Erosion, OfExactFitsLeavesPointsAndPolylines) {
  const PolygonSet square = box(0, 0, 9, 9);
  const Sum point = erosion(square, square, 1);
  EXPECT_TRUE(point.region.empty());
  EXPECT_EQ(points_of(point), (std::vector<Point>{{0, 0}}));
  const Sum line = erosion(square, box(0, 0, 9, 2), 1);
  EXPECT_EQ(points_of(line), (std::vector<Point>{{0, 0}, {0, 7}}));
  EXPECT_TRUE(points_of(erosion(square, box(0, 0, 10, 2), 1)).empty());
  // Two rooms, and a corridor as wide as the square between them.
  PolygonSet rooms = united(box(0, 0, 3, 3), united(box(3, 1, 6, 2), box(6, 0, 9, 3)));
  const Sum corridor = erosion(rooms, box(0, 0, 1, 1), 1);
  EXPECT_EQ(corridor.components, 2U);
  EXPECT_EQ(points_of(corridor), (std::vector<Point>{{2, 1}, {6, 1}}));
}

TEST(Erosion, OfFlatOperands) {
  const PolygonSet square = box(0, 0, 4, 4), point = point_set(1, 2);
  EXPECT_EQ(erosion(square, point, 1).region, box(-1, -2, 3, 2));
  EXPECT_EQ(erosion(square, segment_set({0, 0}, {3, 0}), 1).region, box(0, 0, 1, 4));
  const PolygonSet wall = segment_set({0, 0}, {6, 3});
  EXPECT_EQ(points_of(erosion(wall, segment_set({2, 1}, {0, 0}), 1)),
            (std::vector<Point>{{0, 0}, {4, 2}}));
  EXPECT_EQ(points_of(erosion(wall, wall, 1)), (std::vector<Point>{{0, 0}}));
  EXPECT_TRUE(points_of(erosion(wall, segment_set({0, 0}, {1, 1}), 1)).empty());
  EXPECT_EQ(points_of(erosion(point, point, 2)), (std::vector<Point>{{1, 2}}));
  EXPECT_TRUE(points_of(erosion(wall, box(0, 0, 1, 1), 1)).empty());
  EXPECT_TRUE(erosion({}, square, 1).region.empty());
  EXPECT_THROW(erosion(square, {}, 1), BadInput);
  EXPECT_THROW(erosion(square, square, 0), BadInput);
}

TEST(Erosion, OpeningByASegmentKeepsWhatHasNoArea) {
  const PolygonSet diamond = region({{0, -2}, {2, 0}, {0, 2}, {-2, 0}});
  const Sum chord = opening(diamond, segment_set({0, 0}, {4, 0}), 1);
  EXPECT_TRUE(chord.region.empty());
  EXPECT_EQ(points_of(chord), (std::vector<Point>{{-2, 0}, {2, 0}}));
  // One row passes between both holes, bare beside the rooms.
  const PolygonSet rooms =
      region(rectangle(0, 0, 12, 4), {{{6, 2}, {7, 3}, {5, 3}}, {{6, 2}, {5, 1}, {7, 1}}});
  const Sum rows = opening(rooms, segment_set({0, 0}, {8, 0}), 1);
  EXPECT_EQ(rows.components, 2U);
  EXPECT_EQ(points_of(rows), (std::vector<Point>{{0, 2}, {12, 2}}));
  EXPECT_EQ(points_of(opening(segment_set({0, 0}, {4, 0}), segment_set({0, 0}, {1, 0}), 1)),
            (std::vector<Point>{{0, 0}, {4, 0}}));
}

TEST(Outside, IsValidAndHasTheRingsBackwards) {
  MINKREF_SEEDED(random, 3306);
  expect_law(random, 60, [](const Case& c) -> std::string {
    PolygonSet nested = c.P;
    nested = together(
        region(rectangle(-1000, -1000, 1000, 1000), {rectangle(-900, -900, 900, 900)}), nested);
    for (const PolygonSet& P : {c.P, nested}) {
      const Outside outside = outside_of(P);
      validate(outside.set);
      std::vector<Ring> rings, backwards;
      for_each_ring(P, [&](const Ring& ring) { rings.push_back(ring); });
      for_each_ring(outside.set, [&](const Ring& ring) { backwards.push_back(ring); });
      if (rings.size() + 1 != backwards.size()) return "rings";
      for (std::uint32_t r = 1; r < backwards.size(); ++r) {
        for (std::uint32_t i = 0; i < backwards[r].size(); ++i) {
          const VertexId v = outside.vertex_of_P({r, i}), e = outside.edge_of_P({r, i});
          const Ring& ring = rings.at(v.ring);
          if (ring.at(v.index) != backwards[r][i]) return "vertex";
          if (ring.at((e.index + 1) % ring.size()) != backwards[r][i]) return "edge";
        }
      }
      const PolygonSet back = inside_out(canonicalize(outside.set).region).region;
      if (back != canonicalize(P).region) return "inside out";
    }
    return "";
  });
}

}  // namespace
}  // namespace minkref::testing::of_erosion
