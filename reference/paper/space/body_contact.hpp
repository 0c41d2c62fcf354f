// Collision detection between sP and x - Q in one arithmetic (Behar & Lien 2012, Sec. 3).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/paper/space/two_facets.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"
#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// A body's triangles, with one arithmetic.
template <class T>
class PlacedBody {
 public:
  using Vector = typename TwoFacets<T>::Vector;
  using Corners = std::array<Vector, 3>;

  /// `points`: scaled vertices. `body` must outlive the object. O(n log n).
  PlacedBody(const SpaceOperand& body, std::vector<Vector> points)
      : body_(body), points_(std::move(points)) {
    std::vector<SpaceBox> boxes;
    for (std::uint32_t t = 0; t < body.triangles.size(); ++t) {
      for (const Vector& corner : corners(t)) {
        if (boxes.size() <= t) boxes.emplace_back();
        boxes.back().add(box_of(corner));
      }
    }
    tree_ = SpaceBoxTree(std::move(boxes));
  }

  static SpaceBox box_of(const Vector& point) {
    SpaceBox box;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto [low, high] = enclosure(point[k]);
      box.low[static_cast<std::size_t>(k)] = low;
      box.high[static_cast<std::size_t>(k)] = high;
    }
    return box;
  }

  Corners corners(std::uint32_t triangle) const {
    const auto& [a, b, c] = body_.triangles[triangle].corners;
    return {points_[a], points_[b], points_[c]};
  }
  const SpaceBoxTree& tree() const { return tree_; }
  /// A vertex for each connected surface.
  const std::vector<std::uint32_t>& shell_vertices() const { return body_.shell_vertices; }
  const Vector& point(std::uint32_t v) const { return points_[v]; }

  /// Whether a point off the surface lies inside: counts the winding number from triangles above.
  /// Ties break as if the point moved by (e, e^2, 0) for a vanishing e.
  bool holds(const Vector& v) const {
    SpaceBox column = box_of(v);
    column.high[2] = SpaceBox::infinity;
    int winding = 0;
    tree_.query(column, [&](std::uint32_t t) {
      const Corners c = corners(t);
      const Vector normal = Vector(c[1] - c[0]).cross(Vector(c[2] - c[0]));
      const int facing = sign(normal[2]);
      if (facing == 0 || sign(T(normal.dot(Vector(c[0] - v)))) != facing) return false;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector along = c[(k + 1) % 3] - c[k], from = v - c[k];
        int turn = sign(T(along[0] * from[1] - along[1] * from[0]));
        if (turn == 0) turn = -sign(along[1]);
        if (turn == 0) turn = sign(along[0]);
        if (turn != facing) return false;
      }
      winding += facing;
      return false;
    });
    return winding > 0;
  }

 private:
  const SpaceOperand& body_;
  std::vector<Vector> points_;
  SpaceBoxTree tree_;
};

/// Whether a segment and a triangle share a point; both are closed. As exact as T.
template <class Vector>
bool segment_meets_triangle(const Vector& a, const Vector& b, const std::array<Vector, 3>& t) {
  using T = typename Vector::Scalar;
  const Vector normal = Vector(t[1] - t[0]).cross(Vector(t[2] - t[0]));
  const int from = sign(T(normal.dot(Vector(a - t[0])))),
            to = sign(T(normal.dot(Vector(b - t[0]))));
  if (from * to > 0) return false;
  const Vector along = b - a;
  if (from != 0 || to != 0) {
    bool above = false, below = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector &u = t[k], &v = t[(k + 1) % 3];
      const int turn = sign(T(along.dot(Vector(u - a).cross(Vector(v - a)))));
      above = above || turn > 0;
      below = below || turn < 0;
    }
    return !(above && below);
  }
  // In one plane.
  const auto turn = [&](const Vector& way, const Vector& point) {
    return sign(T(normal.dot(way.cross(point))));
  };
  bool holds_a = true, holds_b = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector &u = t[k], &v = t[(k + 1) % 3], side = v - u;
    const int at_a = turn(side, a - u), at_b = turn(side, b - u);
    holds_a = holds_a && at_a >= 0;
    holds_b = holds_b && at_b >= 0;
    const int at_u = turn(along, u - a), at_v = turn(along, v - a);
    if (at_a * at_b <= 0 && at_u * at_v <= 0 && (at_a != 0 || at_b != 0)) return true;
  }
  return holds_a || holds_b;
}

/// Whether sP meets x - Q. As exact as T.
template <class T>
class BodyContact {
 public:
  using Vector = typename TwoFacets<T>::Vector;

  BodyContact(const PlacedBody<T>& P, const PlacedBody<T>& Q) : P_(P), Q_(Q) {}

  /// Bodies are closed: triangles meet, or a body holds a vertex from each surface.
  bool meets(const Vector& x) const {
    const SpaceBox at = PlacedBody<T>::box_of(x);
    const auto overlap = [&](const SpaceBox& p, const SpaceBox& q) {
      for (std::size_t k = 0; k < 3; ++k) {
        // Each sum is rounded once: only a gap beyond the slack tells the boxes apart.
        const double least = p.low[k] + q.low[k], most = p.high[k] + q.high[k];
        const double slack = 0x1p-51 * (std::abs(p.low[k]) + std::abs(q.low[k]) +
                                        std::abs(p.high[k]) + std::abs(q.high[k]));
        if (at.high[k] < least - slack || at.low[k] > most + slack) return false;
      }
      return true;
    };
    const bool touch =
        P_.tree().pairs_with(Q_.tree(), overlap, [&](std::uint32_t i, std::uint32_t j) {
          auto other = Q_.corners(j);
          for (Vector& corner : other) corner = x - corner;
          return triangles_meet(P_.corners(i), other);
        });
    if (touch) return true;
    for (const std::uint32_t v : Q_.shell_vertices()) {
      if (P_.holds(x - Q_.point(v))) return true;
    }
    for (const std::uint32_t v : P_.shell_vertices()) {
      if (Q_.holds(x - P_.point(v))) return true;
    }
    return false;
  }

 private:
  using Corners = typename PlacedBody<T>::Corners;

  static bool triangles_meet(const Corners& a, const Corners& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (segment_meets_triangle(a[k], a[(k + 1) % 3], b) ||
          segment_meets_triangle(b[k], b[(k + 1) % 3], a)) {
        return true;
      }
    }
    return false;
  }

  const PlacedBody<T>&P_, &Q_;
};

}  // namespace minkref::inline space
