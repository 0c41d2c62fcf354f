// The convolution and the reduced convolution: their edges, and what these cover (Behar & Lien
// 2012, Sec. 3).
#include "reference/plane/convolution/convolution.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reference/plane/routes/simply_connected.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/convolution_rule.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_convolution {
namespace {

using Kind = ConvolutionEdge::Kind;

TEST(Convolution, HasTheEdgesOfTheDefinition) {
  MINKREF_SEEDED(random, 900);
  expect_law(random, 300, [](const Case& c) -> std::string {
    if (sorted(reduced_convolution(c.P, c.Q)) !=
        sorted(convolution_by_definition(c.P, c.Q, false))) {
      return "reduced";
    }
    return sorted(full_convolution(c.P, c.Q)) == sorted(convolution_by_definition(c.P, c.Q, true))
               ? ""
               : "full";
  });
}

TEST(Convolution, ReducedIsThePositivePartOfFull) {
  MINKREF_SEEDED(random, 901);
  expect_law(random, 150, [](const Case& c) -> std::string {
    std::vector<ConvolutionEdge> positive;
    for (const ConvolutionEdge& edge : full_convolution(c.P, c.Q)) {
      if (edge.sign != 1 && edge.sign != -1) return "a sign that is none";
      if (edge.sign == 1) positive.push_back(edge);
    }
    return sorted(positive) == sorted(reduced_convolution(c.P, c.Q)) ? "" : "not a part";
  });
}

TEST(Convolution, HasTheSameEdgesAtEveryScale) {
  MINKREF_SEEDED(random, 902);
  expect_law(random, 100, [](const Case& c) -> std::string {
    for (const Rational& s : {c.scale, Rational(1, 1000), Rational(1000)}) {
      if (reduced_convolution(stretched(c.P, s), c.Q) != reduced_convolution(c.P, c.Q) ||
          full_convolution(stretched(c.P, s), c.Q) != full_convolution(c.P, c.Q)) {
        return "other edges";
      }
    }
    return "";
  });
}

TEST(Convolution, StatisticsCountItsEdges) {
  MINKREF_SEEDED(random, 903);
  expect_law(random, 50, [](const Case& c) -> std::string {
    std::size_t s = 0, t = 0;
    for (const ConvolutionEdge& edge : reduced_convolution(c.P, c.Q)) {
      (edge.kind == Kind::S ? s : t) += 1;
    }
    const Statistics statistics = minkowski_sum(c.P, c.Q, c.scale).statistics;
    return statistics.s_edges == s && statistics.t_edges == t ? "" : "other counts";
  });
}

TEST(Convolution, EdgesAtAScaleAreParentsPlaced) {
  MINKREF_SEEDED(random, 904);
  expect_law(random, 50, [](const Case& c) -> std::string {
    std::vector<Ring> p, q;
    for_each_ring(c.P, [&](const Ring& ring) { p.push_back(ring); });
    for_each_ring(c.Q, [&](const Ring& ring) { q.push_back(ring); });
    for (const ConvolutionEdge& edge : full_convolution(c.P, c.Q)) {
      const bool s_edge = edge.kind == Kind::S;
      const Ring& ring = (s_edge ? p : q)[edge.edge.ring];
      const Point& at = (s_edge ? q : p)[edge.vertex.ring][edge.vertex.index];
      const Point &a = ring[edge.edge.index], &b = ring[(edge.edge.index + 1) % ring.size()];
      const Segment placed = at_scale(edge, c.P, c.Q, c.scale);
      const Point start = s_edge ? c.scale * a + at : a + c.scale * at;
      const Point end = s_edge ? c.scale * b + at : b + c.scale * at;
      if (placed.start != start || placed.end != end) return "misplaced";
    }
    return "";
  });
}

struct LessXY {
  bool operator()(const Point& a, const Point& b) const { return less_xy(a, b); }
};

std::string open_cycle(const Case& c) {
  std::map<Point, int, LessXY> degree;
  for (const ConvolutionEdge& edge : full_convolution(c.P, c.Q)) {
    const Segment at = at_scale(edge, c.P, c.Q, c.scale);
    degree[at.start] += edge.sign;
    degree[at.end] -= edge.sign;
  }
  for (const auto& [point, balance] : degree) {
    if (balance != 0) return "unbalanced at " + text(point);
  }
  return "";
}

TEST(Convolution, FullIsAClosedSignedCycle) {
  MINKREF_SEEDED(random, 905);
  expect_law(random, 300, open_cycle);
}

TEST(Convolution, FullOfLatticePiecesIsAClosedSignedCycle) {
  MINKREF_SEEDED(random, 906);
  expect_law(random, 100, lattice_pieces(4, 3), open_cycle);
}

/// The winding number at x of the full convolution, by a ray to the right; none if x lies on it.
std::optional<int> winding(const Case& c, const Point& x) {
  int number = 0;
  for (const ConvolutionEdge& edge : full_convolution(c.P, c.Q)) {
    const Segment s = at_scale(edge, c.P, c.Q, c.scale);
    if (on_segment(x, s.start, s.end)) return std::nullopt;
    if ((s.start.y > x.y) == (s.end.y > x.y)) continue;
    const bool up = s.end.y > x.y;
    const int side = sign(cross(s.end - s.start, x - s.start));
    if (up ? side > 0 : side < 0) number += up ? edge.sign : -edge.sign;
  }
  return number;
}

Point somewhere(Source& random) {
  return {Rational(random.between(-300, 500), 17), Rational(random.between(-300, 500), 19)};
}

TEST(Convolution, WindingIsZeroExactlyOutsideForSimplePolygons) {
  MINKREF_SEEDED(random, 907);
  Source points(random.seed() + 1);
  const auto make = [](Source& r) {
    return Case{random_simple_polygon(r, r.between(3, 9), 8),
                random_simple_polygon(r, r.between(3, 7), 6), random_scale(r)};
  };
  expect_law(random, 40, make, [&](const Case& c) -> std::string {
    for (int i = 0; i < 15; ++i) {
      const Point x = somewhere(points);
      const std::optional<int> number = winding(c, x);
      if (!number) continue;
      const bool in = contact_at(c.P, c.Q, c.scale, x) != Contact::empty;
      if (*number < 0 || (*number > 0) != in) return "at " + text(x);
    }
    return "";
  });
}

TEST(Convolution, WindingOfAConvexPairIsOneInside) {
  MINKREF_SEEDED(random, 908);
  Source points(random.seed() + 1);
  expect_law(random, 60, convex_polygons(), [&](const Case& c) -> std::string {
    for (int i = 0; i < 15; ++i) {
      const Point x = somewhere(points);
      const std::optional<int> number = winding(c, x);
      const bool in = contact_at(c.P, c.Q, c.scale, x) != Contact::empty;
      if (number && *number != (in ? 1 : 0)) return "at " + text(x);
    }
    return "";
  });
}

TEST(Convolution, WindingCanBeZeroInsideWithHoles) {
  // P and x - Q meet in P, a ring, of Euler characteristic 0.
  const Case c{region(rectangle(0, 0, 8, 8), {rectangle(3, 3, 5, 5)}), box(0, 0, 20, 20), 1};
  const Point x{Rational(151, 10), Rational(149, 10)};
  ASSERT_TRUE(winding(c, x).has_value());
  EXPECT_EQ(*winding(c, x), 0);
  EXPECT_EQ(contact_at(c.P, c.Q, 1, x), Contact::overlapping);
  // Cut along a slit, the operand is simply connected, and the winding number is 1.
  const Case cut{cut_to_simply_connected(c.P), c.Q, 1};
  ASSERT_TRUE(winding(cut, x).has_value());
  EXPECT_EQ(*winding(cut, x), 1);
}

/// Whether the parts of the segments that lie along an edge cover the edge.
bool covered(const Edge& edge, const std::vector<Edge>& by) {
  std::vector<std::pair<Rational, Rational>> parts;
  for (const Edge& other : by) {
    const std::vector<Rational> at = meeting(edge, other);
    if (at.size() == 2) parts.push_back({at[0], at[1]});
  }
  std::sort(parts.begin(), parts.end());
  Rational reached = 0;
  for (const auto& [from, to] : parts) {
    if (from > reached) return false;
    reached = std::max(reached, to);
  }
  return reached == 1;
}

TEST(Convolution, ReducedCoversTheBoundaryOfTheSum) {
  MINKREF_SEEDED(random, 909);
  expect_law(random, 60, [](const Case& c) -> std::string {
    std::vector<Edge> convolution;
    for (const ConvolutionEdge& edge : reduced_convolution(c.P, c.Q)) {
      const Segment s = at_scale(edge, c.P, c.Q, c.scale);
      convolution.push_back({s.start, s.end});
    }
    // The sum comes from a route without the convolution.
    for (const Edge& edge : edges(minkowski_sum(c.P, c.Q, c.scale, Route::definition).region)) {
      std::vector<Edge> along;
      for (const Edge& part : convolution) {
        if (same_direction(edge.to - edge.from, part.to - part.from)) along.push_back(part);
      }
      if (!covered(edge, along)) return "bare: " + text(edge.from) + text(edge.to);
    }
    return "";
  });
}

TEST(Convolution, FullLiesInTheSum) {
  MINKREF_SEEDED(random, 910);
  expect_law(random, 15, [](const Case& c) -> std::string {
    const PolygonSet sum = minkowski_sum(c.P, c.Q, c.scale).region;
    for (const ConvolutionEdge& edge : full_convolution(c.P, c.Q)) {
      const Segment s = at_scale(edge, c.P, c.Q, c.scale);
      for (const Rational& t : {Rational(0), Rational(1, 2), Rational(5, 7)}) {
        const Point x = s.start + t * (s.end - s.start);
        if (where(sum, x) == Where::outside) return "outside at " + text(x);
      }
    }
    return "";
  });
}

TEST(Convolution, ParallelEdgesOfTwoBoxesAreTiledOnce) {
  // Complementary ends: with the same ends on both sides one end of each side of the sum would be
  // bare, with closed ends it would be covered twice.
  const Case c{box(0, 0, 3, 5), box(-1, -1, 1, 6), Rational(3, 2)};
  std::vector<Edge> convolution;
  for (const ConvolutionEdge& edge : reduced_convolution(c.P, c.Q)) {
    const Segment s = at_scale(edge, c.P, c.Q, c.scale);
    convolution.push_back({s.start, s.end});
  }
  EXPECT_EQ(convolution.size(), 8U);
  const PolygonSet sum = box(-1, -1, Rational(11, 2), Rational(27, 2));
  for (const Edge& side : edges(sum)) {
    Rational length = 0;
    for (const Edge& part : convolution) {
      const std::vector<Rational> at = meeting(side, part);
      if (at.size() == 2) length += at[1] - at[0];
    }
    EXPECT_EQ(length, 1);
    EXPECT_TRUE(covered(side, convolution));
  }
}

TEST(Convolution, ParallelEdgesOfConvexPairsAreTiledOnce) {
  MINKREF_SEEDED(random, 911);
  expect_law(random, 100, convex_polygons(8, 2), [](const Case& c) -> std::string {
    // A convex pair's reduced convolution is the sum's boundary: each operand edge gives one edge,
    // and the edges' lengths along each side add up to the side.
    const std::vector<ConvolutionEdge> all = reduced_convolution(c.P, c.Q);
    if (all.size() != c.P.vertices() + c.Q.vertices()) return "another number of edges";
    for (const Edge& side : edges(minkowski_sum(c.P, c.Q, c.scale).region)) {
      Rational length = 0;
      std::vector<Edge> along;
      for (const ConvolutionEdge& edge : all) {
        const Segment s = at_scale(edge, c.P, c.Q, c.scale);
        const std::vector<Rational> at = meeting(side, {s.start, s.end});
        if (at.size() == 2) {
          length += at[1] - at[0];
          along.push_back({s.start, s.end});
        }
      }
      if (length != 1 || !covered(side, along)) return "not tiled: " + text(side.from);
    }
    return "";
  });
}

TEST(Convolution, ReflexAndStraightVerticesAreNotInTheReducedOne) {
  // A dart with a straight vertex: vertex 1 is straight, vertex 3 reflex.
  const PolygonSet dart = region({{0, 0}, {2, -2}, {4, -4}, {2, 0}, {4, 4}});
  const PolygonSet square = box(0, 0, 1, 1);
  for (const ConvolutionEdge& edge : reduced_convolution(dart, square)) {
    if (edge.kind == Kind::T) {
      EXPECT_NE(edge.vertex.index, 1U);
      EXPECT_NE(edge.vertex.index, 3U);
    }
  }
  bool negative = false;
  for (const ConvolutionEdge& edge : full_convolution(dart, square)) {
    if (edge.kind != Kind::T) continue;
    EXPECT_NE(edge.vertex.index, 1U);
    EXPECT_EQ(edge.sign, edge.vertex.index == 3 ? -1 : 1);
    negative = negative || edge.sign < 0;
  }
  EXPECT_TRUE(negative);
}

}  // namespace
}  // namespace minkref::testing::of_convolution
