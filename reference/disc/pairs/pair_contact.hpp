// When an end of one offset feature comes to another, and when two touch: the conditions of the
// Appendix (Behar & Lien 2012), solved for the radius.
#pragma once

#include <cstdint>

#include "reference/disc/pairs/offset_feature.hpp"

namespace minkref::inline disc {

/// The condition on two features a and b that holds with equality.
enum class ContactSlot : std::uint8_t {
  a_first,  ///< the first end of a is on the line or circle of b
  a_last,
  b_first,
  b_last,
  tangent  ///< two circles touch, or a circle and a line
};

/// The place base + t way at the radius t |way|, with t = top / under, both positive; otherwise the
/// condition holds at no radius, or at every radius. Each condition is linear over the radius, and
/// t lies within Q(√(L M)), with the squared lengths L and M of two ways.
template <class N>
struct Contact {
  Vector<N> base, way;
  N squared_way, top, under;

  /// `under` times the way from a point to the place.
  Vector<N> from(const Vector<N>& p) const { return under * (base - p) + top * way; }
  N squared_radius() const {
    const N t = top / under;
    return t * t * squared_way;
  }
};

inline bool is_certainly_positive(const Interval& x) { return x.lower() > 0; }
inline bool is_certainly_positive(const RootNumber& x) { return sign(x) > 0; }

/// An end of a feature on the line of an edge: n (p + ρ m) = h + ρ with unit vectors n and m.
template <class N>
Contact<N> end_on_line(const FeatureNumbers<N>& of, std::size_t end,
                       const FeatureNumbers<N>& line) {
  const Vector<N>&n = line.way[0], &m = of.way[end];
  const N height = dot(n, of.at[end] - line.at[0]), b = dot(n, m);
  const N k = sqrt(of.squared_way[end] * line.squared_way[0]);
  Contact<N> found{of.at[end], m, of.squared_way[end], height, k - b};
  if (is_certainly_positive(b)) {  // (k - b)(k + b) = cross²: no difference of near numbers
    const N across = cross(n, m);
    found.top = height * (k + b);
    found.under = across * across;
  }
  return found;
}

/// An end of a feature on the circle of an arc: |D|² + 2ρ m D = 0, D from the centre to its point.
template <class N>
Contact<N> end_on_circle(const FeatureNumbers<N>& of, std::size_t end,
                         const FeatureNumbers<N>& arc) {
  const Vector<N> D = of.at[end] - arc.at[0];
  return {of.at[end], of.way[end], of.squared_way[end], dot(D, D), N(-2) * dot(of.way[end], D)};
}

/// The circle of an arc touches the line of an edge: at the foot, half as far as the edge is.
template <class N>
Contact<N> circle_on_line(const FeatureNumbers<N>& arc, const FeatureNumbers<N>& line) {
  const N &length = line.squared_way[0], height = dot(line.way[0], arc.at[0] - line.at[0]);
  return {arc.at[0], N(-1) * line.way[0], length, height, N(2) * length};
}

/// The circles of two arcs touch, halfway between the centres.
template <class N>
Contact<N> circles(const FeatureNumbers<N>& a, const FeatureNumbers<N>& b) {
  const Vector<N> D = b.at[0] - a.at[0];
  const N square = dot(D, D);
  return {a.at[0], D, square, square, N(2) * square};
}

/// As printed, "consider the tangent line x0 = xc - s0 r": an arc's end on an edge's line that
/// stays where the circle touches the line.
template <class N>
Contact<N> end_on_staying_line(const FeatureNumbers<N>& arc, std::size_t end,
                               const FeatureNumbers<N>& line) {
  const Vector<N>&n = line.way[0], &m = arc.way[end];
  return {arc.at[0], m, arc.squared_way[end], dot(n, arc.at[0] - line.at[0]), N(-2) * dot(n, m)};
}

}  // namespace minkref::inline disc
