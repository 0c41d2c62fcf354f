#include "reference/scene/free_components.hpp"

#include <algorithm>
#include <numeric>

#include "reference/box_tree.hpp"
#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/plane/location.hpp"
#include "reference/scene/scene_sum.hpp"

namespace minkref::inline scene {
namespace {

/// The complement within a box, the edges turned round; the box's edges come last.
BoundaryGraph complement(const BoundaryGraph& boundary) {
  BoundaryGraph graph{boundary.points, {}};
  graph.edges.reserve(boundary.edges.size() + 4);
  for (const auto& [from, to] : boundary.edges) graph.edges.emplace_back(to, from);
  Point low, high;
  for (const Point& p : boundary.points) {
    look_for_interrupt();
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const auto first = static_cast<std::uint32_t>(graph.points.size());
  const Rational left = low.x - 1, right = high.x + 1, bottom = low.y - 1, top = high.y + 1;
  graph.points.insert(graph.points.end(),
                      {{left, bottom}, {right, bottom}, {right, top}, {left, top}});
  for (std::uint32_t k = 0; k < 4; ++k) graph.edges.emplace_back(first + k, first + (k + 1) % 4);
  return graph;
}

/// Union-find over cells, then points of passages. The least member stands for its class.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t of(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a), b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Finds a cell at a point of the boundary.
class CellFinder {
 public:
  CellFinder(const BoundaryGraph& boundary, const std::vector<std::uint32_t>& cell_of_edge,
             const std::vector<std::uint32_t>& cell_of_point)
      : boundary_(boundary), cell_of_edge_(cell_of_edge), cell_of_point_(cell_of_point) {
    points_.reserve(boundary.points.size());
    for (const Point& point : boundary.points) points_.emplace_back(point);
    std::vector<Box> boxes;
    boxes.reserve(boundary.edges.size());
    for (const auto& [from, to] : boundary.edges) {
      boxes.push_back(box_of(points_[from]));
      boxes.back().add(box_of(points_[to]));
    }
    tree_ = BasicBoxTree<Box>(std::move(boxes));
  }

  /// No entry for a point beside the boundary. O(log n) on usual input.
  std::uint32_t cell_at(const Point& x) const {
    const FilteredPoint at(x);
    std::uint32_t found = no_entry;
    tree_.query(box_of(at), [&](std::uint32_t e) {
      const auto [from, to] = boundary_.edges[e];
      for (const std::uint32_t p : {from, to}) {
        if (boundary_.points[p] == x) found = cell_of_point_[p];
      }
      int winding = 0;
      if (found == no_entry && add_winding(points_[from], points_[to], at, winding))
        found = cell_of_edge_[e];
      return found != no_entry;
    });
    return found;
  }

 private:
  const BoundaryGraph& boundary_;
  const std::vector<std::uint32_t>&cell_of_edge_, &cell_of_point_;
  std::vector<FilteredPoint> points_;
  BasicBoxTree<Box> tree_;
};

std::vector<std::uint32_t> in_order(const std::vector<Point>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    look_for_interrupt();
    return compare_xy(points[a], points[b]) < 0;
  });
  return order;
}

/// A cell at each point of the boundary, after joining all cells there.
std::vector<std::uint32_t> join_at_points(const BoundaryGraph& boundary,
                                          const std::vector<std::uint32_t>& cell_of,
                                          Classes& classes) {
  std::vector<std::uint32_t> cell_at(boundary.points.size(), no_entry);
  for (std::size_t e = 0; e < boundary.edges.size(); ++e) {
    look_for_interrupt();
    for (const std::uint32_t p : {boundary.edges[e].first, boundary.edges[e].second}) {
      if (cell_at[p] == no_entry) cell_at[p] = cell_of[e];
      classes.join(cell_at[p], cell_of[e]);
    }
  }
  return cell_at;
}

}  // namespace

FreeComponents free_components(const BoundaryGraph& boundary, const TightGraph& passages,
                               ContactRule rule) {
  CanonicalParts parts = canonical_parts(complement(boundary));
  FreeComponents result;
  result.cells = std::move(parts.form.region.polygons);
  result.cells[0].outer.clear();  // the box
  const auto cells = static_cast<std::uint32_t>(result.cells.size());
  const bool allowed = rule == ContactRule::allowed;
  Classes classes(cells + (allowed ? passages.points.size() : 0));
  std::vector<std::uint32_t> order;
  if (allowed) {
    const std::vector<std::uint32_t> cell_at = join_at_points(boundary, parts.polygon_of, classes);
    for (const TightGraph::Edge& edge : passages.edges)
      classes.join(cells + edge.from, cells + edge.to);
    order = in_order(passages.points);
    const CellFinder finder(boundary, parts.polygon_of, cell_at);
    for (const std::uint32_t k : order) {
      const std::uint32_t cell = finder.cell_at(passages.points[k]);
      if (cell != no_entry) classes.join(cell, cells + k);
    }
  }
  std::vector<std::uint32_t> number(cells + order.size(), no_entry);
  const auto number_of = [&](std::uint32_t k) {
    std::uint32_t& found = number[classes.of(k)];
    if (found == no_entry) found = static_cast<std::uint32_t>(result.count++);
    return found;
  };
  for (std::uint32_t k = 0; k < cells; ++k) result.of_cell.push_back(number_of(k));
  for (const std::uint32_t k : order) number_of(cells + k);
  if (allowed) {
    for (const TightGraph::Edge& edge : passages.edges)
      result.of_passage.push_back(number_of(cells + edge.from));
  }
  return result;
}

}  // namespace minkref::inline scene
