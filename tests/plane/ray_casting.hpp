// Where a point lies, decided by this room's own arithmetic: it uses only the plain data of
// reference/plane.
#pragma once

#include "tests/plane/shapes.hpp"

namespace minkref::testing {

enum class Where { outside, boundary, inside };

inline Point operator-(const Point& a, const Point& b) {
  return {Rational(a.x - b.x), Rational(a.y - b.y)};
}
inline Point operator+(const Point& a, const Point& b) {
  return {Rational(a.x + b.x), Rational(a.y + b.y)};
}
inline Point operator*(const Rational& s, const Point& p) {
  return {Rational(s * p.x), Rational(s * p.y)};
}
inline Rational cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }
inline Rational dot(const Point& u, const Point& v) { return u.x * v.x + u.y * v.y; }
inline Point midpoint(const Point& a, const Point& b) { return Rational(1, 2) * (a + b); }
inline bool less_xy(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

inline bool on_segment(const Point& x, const Point& a, const Point& b) {
  return sign(cross(b - a, x - a)) == 0 && sign(dot(x - a, x - b)) <= 0;
}

/// Even-odd rule over all rings: right for rings that touch in points and nowhere overlap.
inline Where where(const PolygonSet& set, const Point& x) {
  bool inside = false, boundary = false;
  for_each_ring(set, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (on_segment(x, a, b)) boundary = true;
      if ((a.y > x.y) == (b.y > x.y)) continue;
      // The crossing lies to the right of x iff x is left of the edge taken upwards.
      const int side = sign(cross(b - a, x - a));
      if (b.y > a.y ? side > 0 : side < 0) inside = !inside;
    }
  });
  return boundary ? Where::boundary : inside ? Where::inside : Where::outside;
}

}  // namespace minkref::testing
