#include "reference/plane/routes/simply_connected.hpp"

#include <algorithm>
#include <numeric>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/boundary/set_boundary.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/routes/joined_holes.hpp"

namespace minkref::inline plane {
namespace {

using Indices = std::vector<std::uint32_t>;
using IndexTriangle = std::array<std::uint32_t, 3>;

/// Ear clipping of a weakly simple ring with a connected interior.
class EarClipper {
 public:
  EarClipper(const std::vector<FilteredPoint>& points, const Indices& ring)
      : points_(points), ring_(ring), is_there_(ring.size(), 1) {
    std::vector<Box> boxes;
    boxes.reserve(ring.size());
    for (const std::uint32_t w : ring) {
      const FilteredPoint& p = points[w];
      boxes.push_back({p.x(), p.y(), p.x(), p.y()});
    }
    tree_ = BoxTree(std::move(boxes));
  }

  void clip(std::vector<IndexTriangle>& triangles) {
    auto left = static_cast<std::uint32_t>(ring_.size());
    std::vector<std::uint32_t> before(left), after(left);
    for (std::uint32_t k = 0; k < left; ++k) {
      before[k] = k == 0 ? left - 1 : k - 1;
      after[k] = k + 1 == left ? 0 : k + 1;
    }
    std::uint32_t at = 0;
    for (std::size_t misses = 0; left > 3;) {
      look_for_interrupt_now();
      if (misses > left) throw std::logic_error("triangulate: no ear found");
      const std::uint32_t from = before[at], to = after[at];
      if (is_ear(ring_[from], ring_[at], ring_[to])) {
        triangles.push_back({ring_[from], ring_[at], ring_[to]});
        is_there_[at] = 0;
        after[from] = to;
        before[to] = from;
        --left;
        misses = 0;
      } else {
        ++misses;
      }
      at = to;
    }
    std::array<std::uint32_t, 3> last{before[at], at, after[at]};
    std::rotate(last.begin(), std::min_element(last.begin(), last.end()), last.end());
    triangles.push_back({ring_[last[0]], ring_[last[1]], ring_[last[2]]});
  }

 private:
  /// A convex corner with no vertex inside its triangle or on the open diagonal. Edges meet only at
  /// vertices, so nothing else can enter the triangle.
  bool is_ear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const FilteredPoint &pa = points_[a], &pb = points_[b], &pc = points_[c];
    if (orientation(pa, pb, pc) <= 0) return false;
    // Rounding is monotone: if the triangle holds a point, the box of the corners' doubles holds
    // the point's doubles.
    const Box box{std::min({pa.x(), pb.x(), pc.x()}), std::min({pa.y(), pb.y(), pc.y()}),
                  std::max({pa.x(), pb.x(), pc.x()}), std::max({pa.y(), pb.y(), pc.y()})};
    return !tree_.query(box, [&](std::uint32_t place) {
      const std::uint32_t w = ring_[place];
      if (is_there_[place] == 0 || w == a || w == b || w == c) return false;
      const FilteredPoint& p = points_[w];
      return orientation(pa, pb, p) > 0 && orientation(pb, pc, p) > 0 &&
             orientation(pc, pa, p) >= 0;
    });
  }

  const std::vector<FilteredPoint>& points_;
  const Indices& ring_;
  std::vector<char> is_there_;
  BoxTree tree_;  ///< of the ring's places
};

std::vector<FilteredPoint> filtered(const BoundaryGraph& graph) {
  std::vector<FilteredPoint> points;
  points.reserve(graph.points.size());
  for (const Point& point : graph.points) points.emplace_back(point);
  return points;
}

std::vector<Indices> cut_rings(const BoundaryGraph& graph,
                               const std::vector<FilteredPoint>& points) {
  const Walks walks = boundary_walks(graph);
  std::vector<Indices> outer(walks.components);
  std::vector<std::vector<Indices>> holes(walks.components);
  for (const Walk& walk : walks.walks) {
    if (walk.encloses) {
      outer[walk.component] = walk.points;
    } else {
      holes[walk.component].push_back(walk.points);
    }
  }
  for (std::size_t c = 0; c < outer.size(); ++c) {
    look_for_interrupt();
    outer[c] = joined_holes(points, outer[c], holes[c]);
  }
  return outer;
}

}  // namespace

PolygonSet cut_to_simply_connected(const PolygonSet& set) {
  const auto has_hole = [](const Polygon& polygon) { return !polygon.holes.empty(); };
  if (std::none_of(set.polygons.begin(), set.polygons.end(), has_hole)) return set;
  const BoundaryGraph graph = set_boundary(set).graph;
  PolygonSet result;
  for (const Indices& indices : cut_rings(graph, filtered(graph))) {
    Polygon& polygon = result.polygons.emplace_back();
    for (const std::uint32_t i : indices) polygon.outer.push_back(graph.points[i]);
  }
  return result;
}

std::vector<Triangle> triangulate(const PolygonSet& set) {
  std::vector<Triangle> triangles;
  if (!has_area(set)) return triangles;
  const BoundaryGraph graph = set_boundary(set).graph;
  const auto points = filtered(graph);
  std::vector<IndexTriangle> indices;
  for (const Indices& ring : cut_rings(graph, points)) EarClipper(points, ring).clip(indices);
  for (const auto& [a, b, c] : indices) {
    triangles.push_back({points[a].exact(), points[b].exact(), points[c].exact()});
  }
  Rational total = 0;
  for (const Triangle& t : triangles) {
    const Rational doubled = doubled_area(Ring(t.begin(), t.end()));
    if (sign(doubled) <= 0) throw std::logic_error("triangulate: a triangle without area");
    total += doubled;
  }
  if (total != area(set) * 2) throw std::logic_error("triangulate: areas do not add up");
  return triangles;
}

std::vector<IndexTriangle> triangulate(const std::vector<FilteredPoint>& points,
                                       const Indices& outer, const std::vector<Indices>& holes) {
  std::vector<IndexTriangle> triangles;
  const Indices ring = joined_holes(points, outer, holes);
  EarClipper(points, ring).clip(triangles);
  return triangles;
}

}  // namespace minkref::inline plane
