// The intersection of two convolution edges' lines, at one scale and as a function of the scale.
#pragma once

#include "reference/form.hpp"
#include "reference/number/eigen.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

template <class T>
T cross(const Vector2<T>& u, const Vector2<T>& v) {
  return T(u.x() * v.y() - u.y() * v.x());
}

/// Behar & Lien 2012, Observation 1: the parameter r at which a0 + r v lies on the line b0 + t w,
/// where u = a0 - b0. The printed numerator v_y u_x - v_x u_x is not the right one:
/// docs/definitions.md, "Printed and corrected". The lines must not be parallel. As exact as T.
template <class T>
T observation_1(const Vector2<T>& v, const Vector2<T>& w, const Vector2<T>& u, Form form) {
  const T numerator = form == Form::printed ? T(v.y() * u.x() - v.x() * u.x()) : cross<T>(w, u);
  return T(numerator / cross<T>(v, w));
}

/// A point that moves along a line with the scale: x(s) = x0 + (s - 1) sigma (Behar & Lien 2012,
/// Sec. 4.2).
template <class T>
struct MovingPoint {
  Vector2<T> x0, sigma;
  Vector2<T> at(const T& scale) const { return Vector2<T>(x0 + sigma * T(scale - T(1))); }
};

/// An edge's line at one scale: its start, and its end minus its start.
template <class T>
struct EdgeLine {
  Vector2<T> start, along;
};

template <class T>
EdgeLine<T> line_at(const MovingEdge<Vector2<T>>& edge, const T& scale) {
  const Vector2<T> start = at(start_of(edge), scale);
  return {start, Vector2<T>(at(end_of(edge), scale) - start)};
}

/// The intersection of two lines by a form of Observation 1. As exact as T.
template <class T>
Vector2<T> intersection_of(const EdgeLine<T>& a, const EdgeLine<T>& b, Form form) {
  const T r = observation_1<T>(a.along, b.along, Vector2<T>(a.start - b.start), form);
  return Vector2<T>(T(a.start.x() + a.along.x() * r), T(a.start.y() + a.along.y() * r));
}

/// The intersection of the lines of a and b at a scale.
template <class T>
Vector2<T> intersection_at(const MovingEdge<Vector2<T>>& a, const MovingEdge<Vector2<T>>& b,
                           const T& scale, Form form = Form::corrected) {
  return intersection_of<T>(line_at(a, scale), line_at(b, scale), form);
}

/// The lines of an edge at the scales 1 and 2.
template <class T>
struct EdgeLines {
  EdgeLine<T> first, second;
};

template <class T>
EdgeLines<T> edge_lines(const MovingEdge<Vector2<T>>& edge) {
  return {line_at(edge, T(1)), line_at(edge, T(2))};
}

/// The intersection for all scales, from x0 = x(1) and sigma = x(2) - x(1) (Behar & Lien 2012,
/// Sec. 4.2): exact in exact arithmetic, since both lines move parallel to themselves, linearly in
/// s.
template <class T>
MovingPoint<T> line_intersection(const EdgeLines<T>& a, const EdgeLines<T>& b,
                                 Form form = Form::corrected) {
  const Vector2<T> x0 = intersection_of<T>(a.first, b.first, form);
  return {x0, Vector2<T>(intersection_of<T>(a.second, b.second, form) - x0)};
}

template <class T>
MovingPoint<T> line_intersection(const MovingEdge<Vector2<T>>& a, const MovingEdge<Vector2<T>>& b,
                                 Form form = Form::corrected) {
  return line_intersection<T>(edge_lines(a), edge_lines(b), form);
}

}  // namespace minkref::inline plane
