// The kernel over one scalar type: every sign comes from a number of this type.
#pragma once

#include <utility>

#include "reference/number/eigen.hpp"
#include "reference/number/interval.hpp"
#include "reference/number/mpfr.hpp"
#include "reference/number/rational.hpp"
#include "reference/number/scalar.hpp"
#include "reference/plane/kernel/kernel.hpp"

namespace minkref::inline plane {

/// Doubles that certainly enclose the value.
inline std::pair<double, double> enclosure(double value) { return {value, value}; }
inline std::pair<double, double> enclosure(const Interval& value) {
  return {value.lower(), value.upper()};
}
inline std::pair<double, double> enclosure(const Rational& value) {
  const double nearest = to_double(value);
  return {below(nearest), above(nearest)};
}
inline std::pair<double, double> enclosure(const Mpfr& value) {
  const double nearest = approximate(value);
  return {below(nearest), above(nearest)};
}

template <Scalar T>
class PlainKernel {
 public:
  using Coordinate = T;
  using Vector = Vector2<T>;
  using Parameter = T;
  using Wide = T;
  using Node = Vector2<T>;
  using Query = Vector2<T>;

  int sign(const T& value) const {
    ++counts.by_rational;
    return minkref::sign(value);
  }
  int compare(const T& a, const T& b) const { return sign(T(a - b)); }
  int turn(const Vector& u, const Vector& v) const { return sign(cross(u, v)); }

  static T cross(const Vector& u, const Vector& v) { return T(u.x() * v.y() - u.y() * v.x()); }
  static T dot(const Vector& u, const Vector& v) { return T(u.x() * v.x() + u.y() * v.y()); }
  static Parameter parameter(const T& num, const T& den) { return T(num / den); }
  static double approximation(const Parameter& t) { return approximate(t); }
  int sign_of_linear(const T& slope, const T& value, const Parameter& t) const {
    return sign(T(slope * t + value));
  }

  /// Behar & Lien 2012, Observation 1, in its corrected form: r = (w x e) / (d x e).
  Parameter intersection(const Vector& w, const Vector& d, const Vector& e) const {
    return T((w.x() * e.y() - w.y() * e.x()) / (d.x() * e.y() - d.y() * e.x()));
  }
  Parameter projection(const Vector& w, const Vector& d) const {
    return sign(d.x()) != 0 ? T(w.x() / d.x()) : T(w.y() / d.y());
  }

  Node node(const Vector& vertex) const { return vertex; }
  Node node(const Vector& start, const Vector& d, const Parameter& t) const {
    return Node(T(start.x() + t * d.x()), T(start.y() + t * d.y()));
  }
  int compare_x(const Node& a, const Node& b) const { return sign(T(a.x() - b.x())); }
  int compare_y(const Node& a, const Node& b) const { return sign(T(a.y() - b.y())); }
  int orientation(const Node& a, const Node& b, const Node& c) const {
    return turn(Vector(b - a), Vector(c - a));
  }
  int side(const Vector& a, const Vector& d, const Query& x) const {
    return turn(d, Vector(x - a));
  }

  Box box(const Vector& a, const Vector& b) const {
    const auto ax = enclosure(a.x()), ay = enclosure(a.y());
    Box box{ax.first, ay.first, ax.second, ay.second};
    const auto bx = enclosure(b.x()), by = enclosure(b.y());
    box.add({bx.first, by.first, bx.second, by.second});
    return box;
  }

  Box box(const Query& x) const { return box(x, x); }

  mutable SignCounts counts;
};

}  // namespace minkref::inline plane
