// Whether a point lies inside the interiors' sum, or next to a point of the closed sum, at any
// scale.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// Collision detection (Behar & Lien 2012, Sec. 3) on open sets: whether the interiors of sP and of
/// x - Q meet. A point or segment as an operand counts with its relative interior. Pairs of
/// triangles from P and Q decide, without the convolution.
class InteriorTest {
 public:
  /// O(m^2 + n^2), for the triangulations. Operands must have passed `validate`.
  InteriorTest(const PolygonSet& P, const PolygonSet& Q);
  ~InteriorTest();

  /// Exact. O(mn) pairs of triangles at worst; boxes discard most.
  bool inside(const Point& x, const Rational& scale) const;

  /// Whether the closed sets' sum holds x + ε `towards` for all small ε > 0. Exact: if an edge of a
  /// pair of triangles has x on its line, the direction decides. O(mn) pairs of triangles at worst;
  /// boxes discard most.
  bool in_sum_beside(const Point& x, const Point& towards, const Rational& scale) const;

  /// True only if every point within `error` of (x, y), for both coordinates, certainly lies inside
  /// at every scale within a relative 2^-50 of `scale`. By doubles; about 1 us.
  bool certainly_inside(double x, double y, double error, double scale) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace minkref::inline plane
