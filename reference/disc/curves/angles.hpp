// Angles between vectors, enclosed.
#pragma once

#include <cmath>

#include "reference/disc/curves/patch_numbers.hpp"

namespace minkref::inline disc {

/// The angle from one vector to another, below half a turn: from cosine and sine, both times one
/// factor. The arc tangent of doubles errs by less than two roundings.
inline Interval angle_between(const Vector<Interval>& a, const Vector<Interval>& b) {
  const auto widened = [](double value, double by) -> Interval {
    return {std::nextafter(value - by, -INFINITY), std::nextafter(value + by, INFINITY)};
  };
  const Interval c = dot(a, b), s = cross(a, b);
  const double x = approximate(c), y = approximate(s), length = std::hypot(x, y);
  const double angle = std::atan2(y, x);
  const double off = (c.upper() - c.lower()) + (s.upper() - s.lower());
  if (!(off < length / 4)) return {-4, 4};
  return widened(angle, 2 * off / length + 0x1p-50);
}

}  // namespace minkref::inline disc
