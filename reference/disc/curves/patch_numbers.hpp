// The numbers for a patch and for an edge, as intervals of doubles or exact.
#pragma once

#include "reference/disc/curves/offset_patch.hpp"
#include "reference/number/interval.hpp"
#include "reference/number/radicals/root_order.hpp"
#include "reference/plane/kernel/box.hpp"

namespace minkref::inline disc {

template <class N>
struct Vector {
  N x, y;

  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator*(const N& factor, const Vector& a) { return {factor * a.x, factor * a.y}; }
};

template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class N>
N cross(const Vector<N>& a, const Vector<N>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class N>
Vector<N> turned(const Vector<N>& a) {
  return {-a.y, a.x};
}

using RootPoint = Vector<RootNumber>;

/// Exact.
inline bool are_same(const RootPoint& a, const RootPoint& b) {
  return compare(a.x, b.x) == 0 && compare(a.y, b.y) == 0;
}

inline plane::Box box_of(const Vector<Interval>& p) {
  return {p.x.lower(), p.y.lower(), p.x.upper(), p.y.upper()};
}

/// The sign of a - b. Throws UndecidedSign if intervals leave the sign open.
inline int order(const Interval& a, const Interval& b) { return sign(a - b); }
inline int order(const RootNumber& a, const RootNumber& b) { return compare(a, b); }

/// The number a, moved to a field that has both numbers.
inline Interval joined(const Interval& a, const Interval& /*field_of*/) { return a; }
inline RootNumber joined(const RootNumber& a, const RootNumber& field_of) {
  return a.in(field_of.field());
}

template <class N>
Vector<N> numbers(const Point& p) {
  return {N(p.x), N(p.y)};
}
template <class N>
Vector<N> numbers(const Direction& d) {
  return {N(d.x), N(d.y)};
}

/// Numbers for a closed edge of P.
template <class N>
struct EdgeNumbers {
  Vector<N> start, end, along, normal;
  N squared_length;
  N squared_reach, reach;  ///< the radius times the length

  EdgeNumbers() = default;
  EdgeNumbers(const OffsetEdge& edge, const Rational& squared_radius)
      : start(numbers<N>(edge.start)),
        end(numbers<N>(edge.end)),
        along(numbers<N>(edge.along)),
        normal(numbers<N>(edge.normal)),
        squared_length(edge.squared_length),
        squared_reach(Rational(squared_radius * edge.squared_length)),
        reach(sqrt(squared_reach)) {}
};

/// The sign of the squared distance of a point from a closed edge less a number.
template <class N>
int sign_of_distance(const EdgeNumbers<N>& edge, const Vector<N>& x, const N& square) {
  const Vector<N> w = x - edge.start;
  const N foot = dot(edge.along, w);
  if (sign(foot) <= 0) return sign(dot(w, w) - square);
  if (sign(foot - edge.squared_length) >= 0) {
    const Vector<N> v = x - edge.end;
    return sign(dot(v, v) - square);
  }
  const N height = dot(edge.normal, w);
  return sign(height * height - square * edge.squared_length);
}

inline plane::Box box_of(const EdgeNumbers<Interval>& edge) {
  plane::Box box = box_of(edge.start);
  box.add(box_of(edge.end));
  return box;
}

/// Grows a box by at least so much.
inline plane::Box grown(const plane::Box& box, double by) {
  return {plane::below(box.xmin - by), plane::below(box.ymin - by), plane::above(box.xmax + by),
          plane::above(box.ymax + by)};
}

/// The direction about which an arc lies.
inline Direction middle_of(const OffsetPatch& arc) {
  return {arc.first.x + arc.last.x, arc.first.y + arc.last.y};
}

/// Numbers for an arc. The arc's points come in order along `turned(middle)`.
template <class N>
struct ArcNumbers {
  Vector<N> centre, middle;
  N first, last;  ///< how far along its ends are

  ArcNumbers() = default;
  ArcNumbers(const OffsetPatch& arc, const Rational& squared_radius)
      : centre(numbers<N>(arc.centre)),
        middle(numbers<N>(middle_of(arc))),
        first(bound(arc, arc.first, squared_radius)),
        last(bound(arc, arc.last, squared_radius)) {}

  /// How far along the arc's point with a given normal lies.
  static N bound(const OffsetPatch& arc, const Direction& normal, const Rational& squared_radius) {
    const Rational along = dot(turned(middle_of(arc)), normal);
    return N(along) * sqrt(N(Rational(squared_radius / dot(normal, normal))));
  }
};

}  // namespace minkref::inline disc
