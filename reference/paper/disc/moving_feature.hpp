// The convolution's segments and arcs in one arithmetic, and how they move (Behar & Lien 2012,
// Appendix).
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "reference/disc/curves/patch_numbers.hpp"
#include "reference/disc/pairs/offset_feature.hpp"
#include "reference/number/radicals/surd.hpp"
#include "reference/number/scalar.hpp"
#include "reference/paper/disc/appendix_readings.hpp"

namespace minkref {

/// Exact: rational numbers and their square roots. Called rational, as in the plane.
template <>
class Arithmetic<Surd> {
 public:
  Surd operator()(const Rational& value) const { return {value}; }
  std::string name() const { return "rational"; }
};

inline namespace disc {

template <class T>
T root_of(const T& value) {
  using std::sqrt;
  return sqrt(value);
}

template <class T>
int order_of(const T& a, const T& b) {
  return sign(T(a - b));
}

/// The radius of a disc at a scale.
template <class T>
struct DiscScale {
  T s, r;  ///< the scale, and the radius at s = 1
};

/// A segment, between the ends p + (s - 1) r n, or an arc about a vertex c, between c + s r m and
/// c + s r m' for the normals m and m' of its edges.
template <class T>
struct MovingFeature {
  bool is_arc = false;
  Vector<T> along;                  ///< of a segment
  std::array<Vector<T>, 2> corner;  ///< of P: the ends of the edge; of an arc its centre, twice
  std::array<Vector<T>, 2> start;   ///< of a segment: its ends at s = 1
  std::array<Vector<T>, 2> way;     ///< unit vectors, in which the ends move

  const Vector<T>& centre() const { return corner[0]; }
  Vector<T> end(std::size_t k, const DiscScale<T>& at) const {
    if (is_arc) return corner[k] + T(at.s * at.r) * way[k];
    return start[k] + T(T(at.s - T(1)) * at.r) * way[k];
  }
};

/// The vector through its length.
template <class T>
Vector<T> unit(const Vector<T>& v) {
  const T length = root_of(T(dot(v, v)));
  return {T(v.x / length), T(v.y / length)};
}

/// Whether a normal points from a point on its line to the origin's side. Points that rounding put
/// together have no normal.
template <class T>
bool points_to_origin(const Vector<T>& normal, const Vector<T>& at) {
  try {
    return sign(T(dot(normal, at))) < 0;
  } catch (const UndecidedSign&) {
    return false;
  }
}

/// `r`: the radius at s = 1.
template <class T>
MovingFeature<T> moving_feature(const OffsetFeature& feature, const Arithmetic<T>& in, const T& r,
                                const AppendixReadings& readings) {
  MovingFeature<T> result;
  result.is_arc = feature.is_arc;
  for (std::size_t k = 0; k < 2; ++k) {
    result.corner[k] = {in(feature.at[k].x), in(feature.at[k].y)};
    result.way[k] = unit<T>({in(feature.way[k].x), in(feature.way[k].y)});
  }
  if (feature.is_arc) return result;
  result.along = result.corner[1] - result.corner[0];
  Vector<T> normal = unit<T>({result.along.y, T(-result.along.x)});
  if (readings.from_origin && points_to_origin(normal, result.corner[0])) {
    normal = {T(-normal.x), T(-normal.y)};
  }
  result.way = {normal, normal};
  for (std::size_t k = 0; k < 2; ++k) {
    result.start[k] = readings.of_polygon ? result.corner[k] : result.corner[k] + r * normal;
  }
  return result;
}

/// Whether a way from an arc's centre leads to the arc, which is at most half a circle.
template <class T>
bool is_in_arc(const MovingFeature<T>& arc, const Vector<T>& from_centre) {
  return sign(T(cross(arc.way[0], from_centre))) >= 0 &&
         sign(T(cross(from_centre, arc.way[1]))) >= 0;
}

/// The part of a segment up to a point's foot: 0 at its start, 1 at its end.
template <class T>
T part_along(const MovingFeature<T>& segment, const Vector<T>& x) {
  return T(T(dot(segment.along, x - segment.corner[0])) / T(dot(segment.along, segment.along)));
}

}  // namespace disc
}  // namespace minkref
