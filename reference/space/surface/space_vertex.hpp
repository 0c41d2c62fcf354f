// A point in space beside its doubles, and shared points.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "reference/space/box_tree.hpp"
#include "reference/space/edges/vectors.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// The nearest double with a bound; short integers are exact.
inline BoundedDouble bounded(const Rational& value) {
  const double nearest = to_double(value), size = std::abs(nearest);
  if (size < 0x1p53 && denominator(value) == 1) return {nearest, 0};
  return {nearest, size * 0x1p-52 + std::numeric_limits<double>::min()};
}

/// A point with its nearest doubles, which have the coordinates' order, save for ties.
struct SpaceVertex {
  SpacePoint exact;
  BoundedVector rounded;
  SpaceVertex() = default;
  explicit SpaceVertex(SpacePoint point)
      : exact(std::move(point)), rounded{bounded(exact.x), bounded(exact.y), bounded(exact.z)} {}
};

inline const Rational& coordinate(const SpacePoint& point, std::size_t axis) {
  return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
}

/// Lexicographic: -1, 0 or 1. Exact.
inline int compare(const SpaceVertex& a, const SpaceVertex& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const BoundedDouble &s = a.rounded[k], &t = b.rounded[k];
    if (s.value < t.value) return -1;
    if (s.value > t.value) return 1;
    if (s.error == 0 && t.error == 0) continue;
    const int order = coordinate(a.exact, k).compare(coordinate(b.exact, k));
    if (order != 0) return order < 0 ? -1 : 1;
  }
  return 0;
}

/// The least box around the ends' nearest doubles. A point between the ends has its nearest doubles
/// there too.
inline SpaceBox box_between(const SpaceVertex& a, const SpaceVertex& b) {
  SpaceBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::min(a.rounded[k].value, b.rounded[k].value);
    box.high[k] = std::max(a.rounded[k].value, b.rounded[k].value);
  }
  return box;
}

/// Merges equal points: `points` ascend, and `number` holds each given point's place.
struct SharedPoints {
  std::vector<SpaceVertex> points;
  std::vector<std::uint32_t> number;
};
/// Exact. O(n log n).
SharedPoints shared_points(std::vector<SpaceVertex> given);

/// Vectors between exact points.
using RationalVector = std::array<Rational, 3>;
inline RationalVector operator-(const SpacePoint& a, const SpacePoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// A plane with doubles.
struct FilteredPlane {
  OrientedPlane exact;
  BoundedVector normal;
  BoundedDouble offset;
  explicit FilteredPlane(OrientedPlane plane);
  /// Returns 1 on the normal's side, 0 on the plane, -1 on the other side. Exact.
  int side(const SpaceVertex& vertex) const;
  /// The crossing of the plane with the line through two points at different heights.
  SpacePoint crossing(const SpacePoint& p, const SpacePoint& q) const;

 private:
  Rational height(const SpacePoint& point) const;
};

}  // namespace minkref::inline space
