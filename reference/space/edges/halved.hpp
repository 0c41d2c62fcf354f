// Segments, triangles and parallelograms in halves, with bounds.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// The double as a real number, not as an integer, which BoundedDouble takes for exact.
inline BoundedDouble real(double value) { return {value, std::numeric_limits<double>::min()}; }

inline BoundedVector middle(const BoundedVector& a, const BoundedVector& b) {
  return real(0.5) * (a + b);
}

/// Calls look(part) for each part until a call returns false: two parts for a segment, four for a
/// triangle or a parallelogram with corners in cyclic order. Together the parts cover the whole.
template <class Look>
bool all_halves(std::span<const BoundedVector> corners, Look&& look) {
  const auto part = [&](const auto&... corner) { return look(std::array{corner...}); };
  const BoundedVector &a = corners[0], &b = corners[1];
  const BoundedVector ab = middle(a, b);
  if (corners.size() == 2) return part(a, ab) && part(ab, b);
  const BoundedVector& c = corners[2];
  const BoundedVector bc = middle(b, c);
  if (corners.size() == 3) {
    const BoundedVector ca = middle(c, a);
    return part(ab, bc, ca) && part(a, ab, ca) && part(b, bc, ab) && part(c, ca, bc);
  }
  const BoundedVector& d = corners[3];
  const BoundedVector cd = middle(c, d), da = middle(d, a), at = middle(ab, cd);
  return part(a, ab, at, da) && part(b, bc, at, ab) && part(c, cd, at, bc) && part(d, da, at, cd);
}

inline SpaceBox box_of(std::span<const BoundedVector> corners) {
  SpaceBox box;
  for (const BoundedVector& corner : corners) box.add(box_around(corner));
  return box;
}

}  // namespace minkref::inline space
