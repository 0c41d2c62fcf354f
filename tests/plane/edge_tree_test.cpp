// The tree of turned boxes: what it leaves out is apart, and it leaves out most of what is.
#include "reference/near/edge_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "tests/number/random_numbers.hpp"
#include "tests/spiked_star.hpp"

namespace minkref::testing::of_edge_tree {
namespace {

struct Segment {
  int ax, ay, bx, by;
};

/// Long ones in few directions, short ones, and points.
std::vector<Segment> random_edges(Source& random) {
  std::vector<Segment> edges;
  const int count = random.between(1, 60), size = random.between(3, 1000);
  for (int k = 0; k < count; ++k) {
    const int x = random.between(-size, size), y = random.between(-size, size);
    const int length = random.between(0, 2) * random.between(0, size), turn = random.between(0, 3);
    edges.push_back({x, y, x + (turn == 2 ? 0 : length), y + (turn - 1) * length});
  }
  return edges;
}

NearPoint point(double x, double y) { return {{x, y, 0}, 0}; }

EdgeTree tree_of(const std::vector<Segment>& edges) {
  std::vector<NearPoint> points;
  std::vector<EdgeTree::Edge> ends;
  for (const Segment& e : edges) {
    const auto first = static_cast<std::uint32_t>(points.size());
    ends.push_back({first, first + 1});
    points.push_back(point(e.ax, e.ay));
    points.push_back(point(e.bx, e.by));
  }
  return {points, ends};
}

double distance(const Segment& e, double x, double y) {
  const double dx = e.bx - e.ax, dy = e.by - e.ay, wx = x - e.ax, wy = y - e.ay;
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp((wx * dx + wy * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(wx - t * dx, wy - t * dy);
}

bool meet(const Segment& a, const Segment& b) {
  const auto side = [](const Segment& e, int x, int y) {
    const int turn = (e.bx - e.ax) * (y - e.ay) - (e.by - e.ay) * (x - e.ax);
    return (turn > 0) - (turn < 0);
  };
  const auto holds = [&](const Segment& e, int x, int y) {
    return side(e, x, y) == 0 && x >= std::min(e.ax, e.bx) && x <= std::max(e.ax, e.bx) &&
           y >= std::min(e.ay, e.by) && y <= std::max(e.ay, e.by);
  };
  if (holds(a, b.ax, b.ay) || holds(a, b.bx, b.by) || holds(b, a.ax, a.ay) ||
      holds(b, a.bx, a.by)) {
    return true;
  }
  return side(a, b.ax, b.ay) * side(a, b.bx, b.by) < 0 &&
         side(b, a.ax, a.ay) * side(b, a.bx, a.by) < 0;
}

TEST(EdgeTree, ReportsEachPairThatMeetsOnce) {
  MINKREF_SEEDED(random, 930);
  int meeting = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<Segment> edges = random_edges(random);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    tree_of(edges).pairs([&](std::uint32_t a, std::uint32_t b) {
      EXPECT_LT(a, b);
      EXPECT_TRUE(found.emplace(a, b).second);
    });
    for (std::uint32_t a = 0; a < edges.size(); ++a) {
      for (std::uint32_t b = a + 1; b < edges.size(); ++b) {
        if (!meet(edges[a], edges[b])) continue;
        ++meeting;
        EXPECT_TRUE(found.contains({a, b})) << a << " and " << b << " of " << edges.size();
      }
    }
  }
  EXPECT_GT(meeting, 500);
}

TEST(EdgeTree, ReportsEachEdgeWithinReach) {
  MINKREF_SEEDED(random, 931);
  int within = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<Segment> edges = random_edges(random);
    const EdgeTree tree = tree_of(edges);
    const Segment about{random.between(-999, 999), random.between(-999, 999),
                        random.between(-999, 999), random.between(-999, 999)};
    const double reach = random.between(1, 300);
    std::set<std::uint32_t> found;
    tree.near(point(about.ax, about.ay), point(about.bx, about.by), reach, [&](std::uint32_t e) {
      EXPECT_TRUE(found.insert(e).second);
      return false;
    });
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      const bool is_near =
          meet(edges[e], about) || std::min({distance(about, edges[e].ax, edges[e].ay),
                                             distance(about, edges[e].bx, edges[e].by),
                                             distance(edges[e], about.ax, about.ay),
                                             distance(edges[e], about.bx, about.by)}) <= reach;
      within += is_near;
      EXPECT_TRUE(!is_near || found.contains(e)) << e << " of " << edges.size();
    }
  }
  EXPECT_GT(within, 300);
}

TEST(EdgeTree, StopsWhenToldTo) {
  const EdgeTree tree = tree_of({{0, 0, 1, 1}, {0, 1, 1, 0}});
  int asked = 0;
  EXPECT_TRUE(tree.near(point(0, 0), point(1, 1), 1, [&](std::uint32_t) { return ++asked > 0; }));
  EXPECT_EQ(asked, 1);
}

TEST(EdgeTree, LeavesOutMostPairsOfAStar) {
  const Ring ring = spiked_star(1000).polygons[0].outer;
  std::vector<NearPoint> points;
  std::vector<EdgeTree::Edge> edges;
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    points.push_back(point(to_double(ring[k].x), to_double(ring[k].y)));
    edges.push_back({k, (k + 1) % 1000});
  }
  int count = 0;
  EdgeTree(points, edges).pairs([&](std::uint32_t, std::uint32_t) { ++count; });
  EXPECT_LT(count, 8000);  // neighbours alone are 1000
}

TEST(EdgeTree, APointBeyondDoublesMayBeAnywhere) {
  const double beyond = std::numeric_limits<double>::infinity();
  const std::vector<NearPoint> points{point(0, 0), point(1, 0), point(beyond, 0), point(5, 5)};
  int pairs = 0, near = 0;
  const EdgeTree tree(points, {{0, 1}, {2, 3}});
  tree.pairs([&](std::uint32_t, std::uint32_t) { ++pairs; });
  tree.near(point(-9, 7), point(-9, 8), 1, [&](std::uint32_t e) {
    near += e == 1;
    return false;
  });
  EXPECT_EQ(pairs, 1);
  EXPECT_EQ(near, 1);
}

}  // namespace
}  // namespace minkref::testing::of_edge_tree
