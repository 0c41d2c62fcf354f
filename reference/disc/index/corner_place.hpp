// The corner between two features at a radius, for any kind of number.
#pragma once

#include <type_traits>

#include "reference/disc/diagram/equidistant.hpp"
#include "reference/number/radicals/surd.hpp"

namespace minkref::inline disc {

/// A Surd takes numbers of any fields (patch_numbers.hpp has the others).
inline Surd joined(const Surd& a, const Surd& /*field_of*/) { return a; }

inline Point middle_of(const Point& p, const Point& q) {
  return {(p.x + q.x) / 2, (p.y + q.y) / 2};
}

/// A point's height in front of a line, times the normal's length.
inline Rational height_over(const Point& v, const Site& line) {
  return line.normal.x * v.x + line.normal.y * v.y - line.level();
}

/// √value; rounding may have made the number negative.
template <class N>
N root_or_zero(const N& value) {
  if constexpr (!std::is_same_v<N, Interval>) {
    if (sign(value) < 0) return N(0);
  }
  return sqrt(value);
}

/// The place between two features at a radius, along a part with these features; not between
/// parallel lines. `side_of_end(from, along)`: the side with the part's farther end
/// (corner_motion.hpp).
template <class N, class SideOfEnd>
Vector<N> corner_place(const Site& a, const Site& b, const N& squared_radius,
                       SideOfEnd&& side_of_end) {
  if (a.is_point && b.is_point) {
    const Direction way = from_to(a.point, b.point), across = turned(way);
    const Point middle = middle_of(a.point, b.point);
    const N far =
        root_or_zero(N(squared_radius * N(Rational(1 / dot(way, way))) - N(Rational(1, 4))));
    return numbers<N>(middle) + (N(side_of_end(middle, across)) * far) * numbers<N>(across);
  }
  if (a.is_point != b.is_point) {
    const Site &line = a.is_point ? b : a, &point = a.is_point ? a : b;
    const Direction &normal = line.normal, along = turned(normal);
    const Rational square = line.squared_length(), height = height_over(point.point, line);
    const N reach = sqrt(N(squared_radius * N(square)));
    const N far = root_or_zero(N(N(Rational(2 * height)) * reach - N(Rational(height * height)))),
            inverse(Rational(1 / square));
    return numbers<N>(point.point) + ((reach - N(height)) * inverse) * numbers<N>(normal) +
           (N(side_of_end(point.point, along)) * far * inverse) * numbers<N>(along);
  }
  const N reach_a = sqrt(N(squared_radius * N(a.squared_length()))),
          reach_b = sqrt(joined(N(squared_radius * N(b.squared_length())), reach_a));
  const N e = N(a.level()) + reach_a, f = N(b.level()) + reach_b,
          inverse(Rational(1 / cross(a.normal, b.normal)));
  return {inverse * (e * N(b.normal.y) - f * N(a.normal.y)),
          inverse * (f * N(a.normal.x) - e * N(b.normal.x))};
}

}  // namespace minkref::inline disc
