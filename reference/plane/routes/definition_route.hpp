// The sum as the union of all sums of pairs of triangles, by covering each edge of each sum
// separately.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/kernel/direction_order.hpp"

namespace minkref::inline plane {

/// The union of convex polygons, edge by edge: another polygon's interior covers an open interval
/// of an edge; uncovered parts are boundary. Builds no arrangement. As exact as the kernel.
template <class K>
class ConvexUnion {
 public:
  using Vector = typename K::Vector;
  using Parameter = typename K::Parameter;
  /// A part of an edge with positive length on the union's boundary, the union on its left.
  struct Piece {
    Vector start, direction;
    Parameter from, to;
  };

  explicit ConvexUnion(const K& kernel) : kernel_(kernel) {}

  /// A convex polygon, counter-clockwise, without collinear vertices.
  void add(std::vector<Vector> polygon) { polygons_.push_back(std::move(polygon)); }

  /// O(sum over the edges of the polygons whose boxes they meet) at worst; stops early at a fully
  /// covered edge.
  std::vector<Piece> boundary() const {
    std::vector<Box> boxes;
    for (const auto& polygon : polygons_) {
      Box box = kernel_.box(polygon[0], polygon[1]);
      for (const Vector& v : polygon) box.add(kernel_.box(v, v));
      boxes.push_back(box);
    }
    const BoxTree tree(std::move(boxes));
    std::vector<Piece> result;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      const auto& polygon = polygons_[i];
      for (std::size_t e = 0; e < polygon.size(); ++e) {
        const Vector& start = polygon[e];
        const Vector& end = polygon[(e + 1) % polygon.size()];
        const Vector direction(end - start);
        std::vector<Interval1> open{{zero(direction), one(direction)}};
        tree.query(kernel_.box(start, end), [&](std::uint32_t j) {
          if (j != i) cover(start, direction, polygons_[j], j < i, open);
          return open.empty();
        });
        for (const Interval1& part : open) result.push_back({start, direction, part.from, part.to});
      }
    }
    return result;
  }

 private:
  struct Interval1 {
    Parameter from, to;
  };

  Parameter zero(const Vector& d) const { return kernel_.projection(Vector(d - d), d); }
  Parameter one(const Vector& d) const { return kernel_.projection(d, d); }

  /// Removes from `open` the part of the edge that the polygon covers: its interior always; its
  /// boundary if this runs against the edge (both sides are then covered), or with the edge if the
  /// polygon comes `first` (one copy is kept).
  void cover(const Vector& start, const Vector& direction, const std::vector<Vector>& polygon,
             bool first, std::vector<Interval1>& open) const {
    Parameter from = zero(direction), to = one(direction);
    for (std::size_t e = 0; e < polygon.size(); ++e) {
      const Vector& c = polygon[e];
      const Vector along(polygon[(e + 1) % polygon.size()] - c);
      // Inside: along x (start + t direction - c) > 0.
      const Vector w(start - c);
      const int slope = kernel_.turn(along, direction);
      if (slope == 0) {
        const int side = kernel_.turn(along, w);
        if (side < 0) return;
        if (side == 0 && same_way(kernel_, along, direction) && !first) return;
        continue;  // inside, or on the boundary where that counts as covered
      }
      const Parameter t = kernel_.intersection(Vector(c - start), direction, along);
      if (slope > 0) {
        if (kernel_.compare(t, from) > 0) from = t;
      } else {
        if (kernel_.compare(t, to) < 0) to = t;
      }
      if (kernel_.compare(from, to) >= 0) return;
    }
    std::vector<Interval1> rest;
    for (const Interval1& part : open) {
      if (kernel_.compare(part.from, from) < 0) {
        rest.push_back({part.from, kernel_.compare(from, part.to) < 0 ? from : part.to});
      }
      if (kernel_.compare(to, part.to) < 0) {
        rest.push_back({kernel_.compare(part.from, to) < 0 ? to : part.from, part.to});
      }
    }
    open = std::move(rest);
  }

  const K& kernel_;
  std::vector<std::vector<Vector>> polygons_;
};

/// The sum of two convex polygons (counter-clockwise, no collinear vertices): merges edges by angle
/// and joins parallel edges. Either side may also be a point or a segment (two vertices).
template <class K>
std::vector<typename K::Vector> convex_sum(const K& kernel,
                                           const std::vector<typename K::Vector>& p,
                                           const std::vector<typename K::Vector>& q) {
  using Vector = typename K::Vector;
  const auto lowest = [&](const std::vector<Vector>& polygon) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      const int y = kernel.compare(polygon[i].y(), polygon[least].y());
      if (y < 0 || (y == 0 && kernel.compare(polygon[i].x(), polygon[least].x()) < 0)) least = i;
    }
    return least;
  };
  // From the lowest, leftmost vertex the edges run through the angles [0, 360), half turn 1 before
  // half turn 0.
  const auto angle_before = [&](const Vector& u, const Vector& v) {
    const int hu = half_turn(kernel, u), hv = half_turn(kernel, v);
    return hu != hv ? hu > hv : kernel.turn(u, v) > 0;
  };
  const std::size_t p0 = lowest(p), q0 = lowest(q);
  const std::size_t np = p.size() < 2 ? 0 : p.size(), nq = q.size() < 2 ? 0 : q.size();
  const auto edge = [](const std::vector<Vector>& polygon, std::size_t i) {
    return Vector(polygon[(i + 1) % polygon.size()] - polygon[i % polygon.size()]);
  };
  std::vector<Vector> result{Vector(p[p0] + q[q0])};
  std::size_t i = 0, j = 0;
  while (i < np || j < nq) {
    Vector step;
    if (j == nq || (i < np && angle_before(edge(p, p0 + i), edge(q, q0 + j)))) {
      step = edge(p, p0 + i++);
    } else if (i == np || angle_before(edge(q, q0 + j), edge(p, p0 + i))) {
      step = edge(q, q0 + j++);
    } else {
      step = Vector(edge(p, p0 + i) + edge(q, q0 + j));
      ++i;
      ++j;
    }
    result.push_back(Vector(result.back() + step));
  }
  result.pop_back();  // the walk is closed
  return result;
}

}  // namespace minkref::inline plane
