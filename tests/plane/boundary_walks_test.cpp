// Walks along the boundary of a set given as a graph.
#include <gtest/gtest.h>

#include "reference/plane/boundary/boundary_graph.hpp"
#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_boundary_walks {
namespace {

/// The rings cut at each other's vertices, their coincident vertices made one.
BoundaryGraph graph(const PolygonSet& set) {
  BoundaryGraph graph;
  const auto name = [&](const Point& p) {
    const auto found = std::find(graph.points.begin(), graph.points.end(), p);
    if (found == graph.points.end()) graph.points.push_back(p);
    return static_cast<std::uint32_t>(std::find(graph.points.begin(), graph.points.end(), p) -
                                      graph.points.begin());
  };
  const std::vector<Edge> all = edges(set);
  for (const Edge& edge : all) {
    std::vector<std::pair<Rational, Point>> stops{{0, edge.from}, {1, edge.to}};
    for (const Edge& other : all) {
      const Point d = edge.to - edge.from;
      if (other.from != edge.from && other.from != edge.to &&
          on_segment(other.from, edge.from, edge.to)) {
        stops.push_back({Rational(dot(other.from - edge.from, d) / dot(d, d)), other.from});
      }
    }
    std::sort(stops.begin(), stops.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (stops[i].first == stops[i + 1].first) continue;
      graph.edges.push_back({name(stops[i].second), name(stops[i + 1].second)});
    }
  }
  return graph;
}

TEST(BoundaryWalks, UseEachEdgeOnceAndCloseUp) {
  MINKREF_SEEDED(random, 1500);
  expect_law(random, 150, [](const Case& c) -> std::string {
    const BoundaryGraph boundary = graph(c.P);
    auto left = boundary.edges;
    const Walks walks = boundary_walks(boundary);
    std::vector<int> outer(walks.components);
    for (const Walk& walk : walks.walks) {
      if (walk.component >= walks.components) return "a component that is none";
      outer[walk.component] += walk.encloses;
      Ring ring;
      for (std::size_t i = 0; i < walk.points.size(); ++i) {
        const std::pair edge{walk.points[i], walk.points[(i + 1) % walk.points.size()]};
        const auto found = std::find(left.begin(), left.end(), edge);
        if (found == left.end()) return "an edge that is none, or twice";
        left.erase(found);
        ring.push_back(boundary.points[walk.points[i]]);
      }
      if ((sign(doubled_area(ring)) > 0) != walk.encloses) return "encloses";
    }
    if (!left.empty()) return "edges are left";
    for (const int count : outer) {
      if (count != 1) return "one outer walk for each component";
    }
    const Canonical form = canonicalize(c.P);
    if (walks.components != form.components || walks.holes != form.holes) return "counts";
    return unequal(form.region, canonical_form(boundary).region);
  });
}

TEST(BoundaryWalks, SquareWithADiamondTouchingTwoSides) {
  const Walks walks =
      boundary_walks(graph(region(rectangle(0, 0, 4, 4), {{{2, 0}, {1, 2}, {2, 4}, {3, 2}}})));
  EXPECT_EQ(walks.components, 2U);
  EXPECT_EQ(walks.holes, 1U);
  EXPECT_EQ(walks.walks.size(), 2U);
}

TEST(BoundaryWalks, IslandInALakeInAnIsland) {
  PolygonSet set = region(rectangle(0, 0, 9, 9), {rectangle(1, 1, 8, 8)});
  set = together(set, region(rectangle(2, 2, 7, 7), {rectangle(3, 3, 6, 6)}));
  set = together(set, box(4, 4, 5, 5));
  const Walks walks = boundary_walks(graph(set));
  EXPECT_EQ(walks.components, 3U);
  EXPECT_EQ(walks.holes, 2U);
  const Canonical form = canonical_form(graph(set));
  EXPECT_EQ(form.region, canonicalize(set).region);
  ASSERT_EQ(form.region.polygons.size(), 3U);
  EXPECT_EQ(form.region.polygons[0].holes, (std::vector<Ring>{{{1, 1}, {1, 8}, {8, 8}, {8, 1}}}));
}

}  // namespace
TEST(BoundaryWalks, ManyHolesBelongToTheirOwnFrames) {
  PolygonSet frames;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      const int a = 10 * x + y % 3, b = 10 * y;
      frames = together(
          frames, region(rectangle(a, b, a + 7, b + 7), {rectangle(a + 1, b + 1, a + 6, b + 6)}));
      frames = together(frames, region(rectangle(a + 2, b + 2, a + 5, b + 5),
                                       {rectangle(a + 3, b + 3, a + 4, b + 4)}));
    }
  }
  const Canonical form = canonicalize(frames);
  EXPECT_EQ(form.components, 288U);
  EXPECT_EQ(form.holes, 288U);
  for (const Polygon& polygon : form.region.polygons) {
    ASSERT_EQ(polygon.holes.size(), 1U);
    EXPECT_EQ(polygon.holes[0][0], (polygon.outer[0] + Point{1, 1}));
  }
}

}  // namespace minkref::testing::of_boundary_walks
