// Collision detection: whether P and x - Q meet, by their boundaries and containment (Behar & Lien
// 2012, Sec. 3).
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/kernel/operand.hpp"

namespace minkref::inline plane {

/// Decides whether points belong to P + Q, from the operands alone. Requires P already scaled.
template <class K>
class Collision {
 public:
  using Vector = typename K::Vector;
  using Query = typename K::Query;

  Collision(const K& kernel, const Operand<Vector>& P, const Operand<Vector>& Q)
      : kernel_(kernel),
        edges_p_(edges(P)),
        edges_q_(edges(Q)),
        tree_p_(boxes(edges_p_)),
        tree_q_(boxes(edges_q_)),
        heads_p_(heads(P)),
        heads_q_(heads(Q)) {}

  /// Whether x belongs to the closed set P + Q. As exact as the kernel's `side`. O(log(m + n) + k)
  /// for k pairs of overlapping boxes, and a ray's crossings for each ring that is near.
  bool meets(const Query& x) const {
    const Box at = kernel_.box(x);
    const auto overlap = [&at](const Box& p, const Box& q) { return p.overlaps(reflected(q, at)); };
    if (tree_p_.pairs_with(tree_q_, overlap, [&](std::uint32_t i, std::uint32_t j) {
          return cross(edges_p_[i], edges_q_[j], x);
        })) {
      return true;
    }
    // The boundaries do not meet: each polygon of one side lies wholly inside or outside the other.
    if (one_inside(heads_q_, edges_p_, tree_p_, heads_p_.about, x)) return true;
    return one_inside(heads_p_, edges_q_, tree_q_, heads_q_.about, x);
  }

 private:
  struct Edge {
    Vector start, end, direction;
  };

  static std::vector<Edge> edges(const Operand<Vector>& operand) {
    std::vector<Edge> result;
    for (const auto& ring : operand.rings) {
      if (ring.size() < 2) continue;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vector& a = ring[i];
        const Vector& b = ring[(i + 1) % ring.size()];
        result.push_back({a, b, Vector(b - a)});
      }
    }
    return result;
  }
  std::vector<Box> boxes(const std::vector<Edge>& edges) const {
    std::vector<Box> result;
    result.reserve(edges.size());
    for (const Edge& edge : edges) result.push_back(kernel_.box(edge.start, edge.end));
    return result;
  }

  /// The first vertex of each outer ring, a tree over these vertices, and the box about all rings.
  struct Heads {
    std::vector<Vector> vertices;
    BoxTree tree;
    Box about;
  };
  Heads heads(const Operand<Vector>& operand) const {
    Heads result;
    std::vector<Box> boxes;
    for (std::size_t r = 0; r < operand.rings.size(); ++r) {
      if (!operand.is_outer[r]) continue;
      const Vector& head = result.vertices.emplace_back(operand.rings[r][0]);
      boxes.push_back(kernel_.box(head, head));
      for (const Vector& vertex : operand.rings[r]) result.about.add(kernel_.box(vertex, vertex));
    }
    result.tree = BoxTree(std::move(boxes));
    return result;
  }
  /// Whether x - v lies inside the region with these edges, in the box `about`, for one of the
  /// heads v. Looks at heads within the box's reach only.
  bool one_inside(const Heads& heads, const std::vector<Edge>& edges, const BoxTree& tree,
                  const Box& about, const Query& x) const {
    return heads.tree.query(reflected(about, kernel_.box(x)), [&](std::uint32_t i) {
      return holds(edges, tree, heads.vertices[i], x);
    });
  }

  /// Whether the closed edges p and x - q meet: x against the parallelogram p + q.
  bool cross(const Edge& p, const Edge& q, const Query& x) const {
    const int q0 = kernel_.side(Vector(p.start + q.start), p.direction, x);
    const int q1 = kernel_.side(Vector(p.start + q.end), p.direction, x);
    if (q0 * q1 > 0) return false;
    const int p0 = kernel_.side(Vector(p.start + q.start), q.direction, x);
    const int p1 = kernel_.side(Vector(p.end + q.start), q.direction, x);
    if (p0 * p1 > 0) return false;
    if (q0 == 0 && q1 == 0 && p0 == 0 && p1 == 0) return overlap_on_line(p, q, x);
    return true;
  }

  /// For p and x - q on a common line: x lies between the extreme sums of end points.
  bool overlap_on_line(const Edge& p, const Edge& q, const Query& x) const {
    const Vector across(-p.direction.y(), p.direction.x());
    const Vector sums[4] = {Vector(p.start + q.start), Vector(p.start + q.end),
                            Vector(p.end + q.start), Vector(p.end + q.end)};
    bool ahead = false, behind = false;
    for (const Vector& sum : sums) {
      const int side = kernel_.side(sum, across, x);
      ahead = ahead || side >= 0;
      behind = behind || side <= 0;
    }
    return ahead && behind;
  }

  /// Whether x - v lies inside the region with these edges: crossings of a ray to the left. On the
  /// boundary either answer is possible, but then the boundaries meet and the question is not
  /// asked.
  bool holds(const std::vector<Edge>& edges, const BoxTree& tree, const Vector& v,
             const Query& x) const {
    bool inside = false;
    const Vector rightwards = unit_x();
    Box ray = reflected(kernel_.box(v, v), kernel_.box(x));
    ray.xmin = -std::numeric_limits<double>::infinity();
    tree.query(ray, [&](std::uint32_t e) {
      const Edge& edge = edges[e];
      const Vector start(edge.start + v), end(edge.end + v);
      const bool start_above = kernel_.side(start, rightwards, x) < 0;
      const bool end_above = kernel_.side(end, rightwards, x) < 0;
      if (start_above == end_above) return false;
      const int side = kernel_.side(start, edge.direction, x);
      if (end_above ? side < 0 : side > 0) inside = !inside;
      return false;
    });
    return inside;
  }
  static Vector unit_x() { return Vector(typename K::Coordinate(1), typename K::Coordinate(0)); }

  const K& kernel_;
  std::vector<Edge> edges_p_, edges_q_;
  BoxTree tree_p_, tree_q_;
  Heads heads_p_, heads_q_;
};

}  // namespace minkref::inline plane
