// Whether a point lies in the sum of the interiors, at any scale.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "reference/plane/polygon_set.hpp"

namespace minkref {

/// Collision detection (Behar & Lien 2012, Sec. 3) on open sets: whether the interiors of sP and of
/// x - Q meet. A point or segment as an operand counts with its relative interior. Decided by pairs
/// of triangles, one of P and one of Q; nothing of the convolution is used.
class InteriorTest {
 public:
  /// O(m^2 + n^2), for the triangulations. Operands must have passed `validate`.
  InteriorTest(const PolygonSet& P, const PolygonSet& Q);
  ~InteriorTest();

  /// Exact. O(mn) pairs of triangles at worst; boxes discard most.
  bool inside(const Point& x, const Rational& scale) const;

  /// Whether a point lies in the sum of the closed sets. Exact. O(mn) pairs of triangles.
  bool in_closed_sum(const Point& x, const Rational& scale) const;

  /// Triangles that settled the last question are tried first.
  struct Hint {
    std::uint32_t of_P = 0, of_Q = 0;
  };
  /// A disc of constant radius around x0 + s x1, in doubles.
  struct MovingDisc {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0, radius = 0;
  };
  /// True only if the disc is certainly inside at every scale from `from` to `to`, 0 < from <= to:
  /// one pair of triangles holds it. In doubles; 50 ns where the hint is right, some 10 us else.
  bool certainly_inside(const MovingDisc& disc, double from, double to, Hint& hint) const;

  /// True only if every point within `error` of (x, y), in both coordinates, is certainly inside
  /// at every scale within a relative 2^-50 of `scale`. In doubles; about 1 us.
  bool certainly_inside(double x, double y, double error, double scale) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace minkref
