// Free components of a sum's complement: those that FreeSpace finds by points.
#include "reference/scene/free_components.hpp"

#include <gtest/gtest.h>

#include <map>

#include "reference/motion/free_space.hpp"
#include "reference/plane/boundary/set_boundary.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/contact_by_edges.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing::of_free_components {
namespace {

/// The pieces as a graph, cut at the boundary's points too.
TightGraph graph_of(const std::vector<TightPassage>& pieces, const BoundaryGraph& boundary) {
  TightGraph graph;
  const auto name = [&](const Point& p) {
    auto found = std::find(graph.points.begin(), graph.points.end(), p);
    if (found == graph.points.end()) found = graph.points.insert(found, p);
    return static_cast<std::uint32_t>(found - graph.points.begin());
  };
  for (const TightPassage& piece : pieces) {
    if (piece.points.size() == 1) {
      graph.edges.push_back({name(piece.points[0]), name(piece.points[0]), {}});
    }
    for (std::size_t i = 0; i + 1 < piece.points.size(); ++i) {
      const Point &a = piece.points[i], &b = piece.points[i + 1];
      std::vector<Point> stops{a, b};
      for (const Point& p : boundary.points) {
        if (p != a && p != b && on_segment(p, a, b)) stops.push_back(p);
      }
      std::sort(stops.begin(), stops.end(),
                [](const Point& p, const Point& q) { return compare_xy(p, q) < 0; });
      for (std::size_t k = 0; k + 1 < stops.size(); ++k)
        graph.edges.push_back({name(stops[k]), name(stops[k + 1]), {}});
    }
  }
  return graph;
}

std::string compared(const Case& c) {
  const Sum sum = minkowski_sum(c.P, c.Q, c.scale, Route::paper, "rational", Passages::find);
  const BoundaryGraph boundary = set_boundary(sum.region).graph;
  const TightGraph passages = graph_of(*sum.tight_passages, boundary);
  for (const ContactRule rule : {ContactRule::allowed, ContactRule::forbidden}) {
    const FreeComponents found = free_components(boundary, passages, rule);
    if (found.cells.size() != sum.holes + 1) return "cells";
    if (!found.cells[0].outer.empty() || found.of_cell[0] != 0) return "the cell without bound";
    const FreeSpace by_points(sum, rule, {});
    if (found.count != by_points.parts()) {
      return std::to_string(found.count) + " components, not " + std::to_string(by_points.parts());
    }
    const bool allowed = rule == ContactRule::allowed;
    if (found.of_passage.size() != (allowed ? passages.edges.size() : 0)) return "passages";
    std::map<std::size_t, std::uint32_t> names;
    const auto same = [&](const Point& x, std::uint32_t component) {
      const auto part = by_points.part_of(x);
      return part && names.emplace(*part, component).first->second == component;
    };
    for (std::size_t k = 1; k < found.cells.size(); ++k) {
      const Ring& outer = found.cells[k].outer;
      if (allowed && !same(outer[0], found.of_cell[k])) return "a cell at " + text(outer[0]);
    }
    for (std::size_t k = 0; k < found.of_passage.size(); ++k) {
      const Point& x = passages.points[passages.edges[k].from];
      if (!same(x, found.of_passage[k])) return "a passage at " + text(x);
    }
  }
  return "";
}

TEST(FreeComponents, AreThoseThatPointsTell) {
  MINKREF_SEEDED(random, 5001);
  expect_law(random, 300, compared);
  expect_law(random, 300, lattice_pieces(2, 5), compared);
}

TEST(FreeComponents, EmptySetsHaveOne) {
  const FreeComponents found = free_components({}, {}, ContactRule::allowed);
  EXPECT_EQ(found.count, 1U);
  EXPECT_EQ(found.cells.size(), 1U);
}

TEST(FreeComponents, CornersThatTouchCloseARoomOnlyWithContactForbidden) {
  PolygonSet ring;
  for (const auto& [x, y] : {std::pair{0, 1}, {1, 0}, {2, 1}, {1, 2}})
    ring.polygons.push_back({rectangle(x, y, x + 1, y + 1), {}});
  const BoundaryGraph boundary = set_boundary(ring).graph;
  const FreeComponents forbidden = free_components(boundary, {}, ContactRule::forbidden);
  EXPECT_EQ(forbidden.count, 2U);
  EXPECT_EQ(forbidden.cells[1].outer, (Ring{{1, 1}, {2, 1}, {2, 2}, {1, 2}}));
  EXPECT_EQ(free_components(boundary, {}, ContactRule::allowed).count, 1U);
}

}  // namespace
}  // namespace minkref::testing::of_free_components
