#include "reference/plane/routes/simply_connected.hpp"

#include <algorithm>
#include <numeric>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/boundary/set_boundary.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

using Indices = std::vector<std::uint32_t>;
using IndexTriangle = std::array<std::uint32_t, 3>;

/// Joins a component's walks, the outer walk first.
class Cutter {
 public:
  explicit Cutter(const std::vector<FilteredPoint>& points) : points_(points) {}

  Indices join(Indices ring, std::vector<Indices> holes) const {
    // Holes from right to left: a ray to the right meets only joined rings.
    std::vector<std::pair<std::uint32_t, const Indices*>> order;
    for (const Indices& hole : holes) {
      order.emplace_back(
          *std::max_element(hole.begin(), hole.end(),
                            [&](auto a, auto b) { return compare_xy(points_[a], points_[b]) < 0; }),
          &hole);
    }
    std::stable_sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      return compare_xy(points_[a.first], points_[b.first]) > 0;
    });
    for (const auto& [rightmost, hole] : order) {
      look_for_interrupt_now();
      const std::uint32_t end = visible_vertex(ring, rightmost);
      splice(ring, corner(ring, end, rightmost), *hole, corner(*hole, rightmost, end));
    }
    return ring;
  }

 private:
  /// A vertex of the ring visible from m, to the right (Eberly, "Triangulation by ear clipping").
  std::uint32_t visible_vertex(const Indices& ring, std::uint32_t m) const {
    const FilteredPoint& at = points_[m];
    bool found = false, hit_vertex = false;
    Rational nearest;
    std::uint32_t a_hit = 0, b_hit = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
      const int ya = compare_y(points_[a], at), yb = compare_y(points_[b], at);
      Rational x;
      bool vertex = false;
      if (ya == 0) {
        if (compare_x(points_[a], at) <= 0) continue;
        x = points_[a].exact().x;
        vertex = true;
      } else if (ya * yb < 0) {
        // Only an edge that runs upwards has the interior on the side of m.
        if (ya > 0 || orientation(points_[a], points_[b], at) <= 0) continue;
        const Point &p = points_[a].exact(), &q = points_[b].exact();
        x = p.x + (at.exact().y - p.y) / (q.y - p.y) * (q.x - p.x);
      } else {
        continue;
      }
      if (found && !(x < nearest)) continue;
      found = true;
      hit_vertex = vertex;
      nearest = x;
      a_hit = a;
      b_hit = b;
    }
    if (hit_vertex) return a_hit;
    const bool upper = compare_x(points_[b_hit], points_[a_hit]) >= 0;
    const std::uint32_t end = upper ? b_hit : a_hit;
    // Vertices within the triangle of m, the point hit and `end` may hide `end`: the vertex nearest
    // to the ray by angle, then by distance, is visible.
    const int sense = upper ? 1 : -1;
    std::uint32_t best = end;
    for (const std::uint32_t r : ring) {
      if (r == best || compare_y(points_[r], at) != sense) continue;
      if (orientation(points_[a_hit], points_[b_hit], points_[r]) < 0) continue;
      if (orientation(at, points_[end], points_[r]) * sense > 0) continue;
      const int angle = orientation(at, points_[best], points_[r]) * sense;
      if (angle < 0 || (angle == 0 && compare_x(points_[r], points_[best]) < 0)) best = r;
    }
    return best;
  }

  /// The position of `point` within the ring whose interior wedge holds the direction to `towards`.
  std::size_t corner(const Indices& ring, std::uint32_t point, std::uint32_t towards) const {
    const std::size_t n = ring.size();
    std::size_t last = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (ring[i] != point) continue;
      last = i;
      const FilteredPoint &at = points_[point], &out = points_[ring[(i + 1) % n]],
                          &in = points_[ring[(i + n - 1) % n]], &to = points_[towards];
      const int wedge = orientation(at, out, in);
      const int after_out = orientation(at, out, to), before_in = orientation(at, to, in);
      const bool inside = wedge > 0   ? after_out > 0 && before_in > 0
                          : wedge < 0 ? after_out > 0 || before_in > 0
                                      : after_out > 0 || ring[(i + 1) % n] == ring[(i + n - 1) % n];
      if (inside) return i;
    }
    return last;
  }

  static void splice(Indices& ring, std::size_t at, const Indices& hole, std::size_t from) {
    Indices detour;
    const std::size_t steps = hole.size() == 1 ? 0 : hole.size();
    for (std::size_t k = 0; k <= steps; ++k) detour.push_back(hole[(from + k) % hole.size()]);
    detour.push_back(ring[at]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(at) + 1, detour.begin(), detour.end());
  }

  const std::vector<FilteredPoint>& points_;
};

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
  const Cutter cutter(points);
  for (std::size_t c = 0; c < outer.size(); ++c)
    outer[c] = cutter.join(std::move(outer[c]), std::move(holes[c]));
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
  const Indices ring = Cutter(points).join(outer, holes);
  EarClipper(points, ring).clip(triangles);
  return triangles;
}

}  // namespace minkref::inline plane
