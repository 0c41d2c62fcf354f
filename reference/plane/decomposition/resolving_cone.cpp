#include "reference/plane/decomposition/resolving_cone.hpp"

#include <algorithm>
#include <limits>

#include "reference/number/interval.hpp"
#include "reference/plane/kernel/box.hpp"

namespace minkref::inline plane {
namespace {

template <class N>
struct At {
  N x, y;
};
At<Rational> exact(const FilteredPoint& p) { return {p.exact().x, p.exact().y}; }
Interval around(double rounded) { return {below(rounded), above(rounded)}; }
At<Interval> enclosed(const FilteredPoint& p) { return {around(p.x()), around(p.y())}; }

template <class N>
At<N> operator-(const At<N>& a, const At<N>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class N>
N cross(const At<N>& a, const At<N>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class N>
N dot(const At<N>& a, const At<N>& b) {
  return a.x * b.x + a.y * b.y;
}

Rational greater(const Rational& a, const Rational& b) { return std::max(a, b); }
Interval greater(const Interval& a, const Interval& b) {
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}
bool is_above(const Rational& a, const Rational& b) { return a > b; }
bool is_above(const Interval& a, const Interval& b) { return a.lower() > b.upper(); }

/// Signs at a segment's ends; a negative sign tells that a line cuts this end off.
struct EndSigns {
  int from, to;

  bool miss() const { return from < 0 && to < 0; }
};

/// The part of a segment between two parameters from 0 to 1.
template <class N>
struct Stretch {
  N low = 0, high = 1;

  /// Cuts off the ends with a negative sign, where a linear value vanishes.
  void cut(const EndSigns& signs, const N& at_from, const N& at_to) {
    if (signs.from >= 0 && signs.to >= 0) return;
    const N t = at_from / (at_from - at_to);
    if (signs.from < 0) low = greater(low, t);
    if (signs.to < 0) high = -greater(-high, -t);
  }
};

/// The parameter of the nearest point to the origin on the part of a segment between two lines
/// through the origin; nothing if the part is certainly empty.
template <class N>
std::optional<N> nearest_parameter(const At<N>& from, const At<N>& along, const At<N>& first,
                                   const EndSigns& by_first, const At<N>& second,
                                   const EndSigns& by_second) {
  const At<N> to{from.x + along.x, from.y + along.y};
  Stretch<N> inside;
  inside.cut(by_first, cross(first, from), cross(first, to));
  inside.cut(by_second, cross(from, second), cross(to, second));
  if (is_above(inside.low, inside.high)) return std::nullopt;
  const N foot = -dot(from, along) / dot(along, along);
  return -greater(-greater(foot, inside.low), -inside.high);
}

}  // namespace

/// On which sides of both lines a wall's ends lie.
struct ResolvingCone::Sides {
  EndSigns first, second;
};

std::optional<ResolvingCone::Sides> ResolvingCone::sides(const FilteredPoint& from,
                                                         const FilteredPoint& to) const {
  // The cone: left of the line from the apex to `first`, right of the line to `second`.
  Sides found{{orientation(apex_, first_, from), orientation(apex_, first_, to)}, {0, 0}};
  if (found.first.miss()) return std::nullopt;
  found.second = {-orientation(apex_, second_, from), -orientation(apex_, second_, to)};
  if (found.second.miss()) return std::nullopt;
  return found;
}

std::optional<Point> ResolvingCone::nearest(const FilteredPoint& from,
                                            const FilteredPoint& to) const {
  const std::optional<Sides> at = sides(from, to);
  if (!at) return std::nullopt;
  const At<Rational> v = exact(apex_), p = exact(from), along = exact(to) - p;
  const auto t = nearest_parameter<Rational>(p - v, along, exact(first_) - v, at->first,
                                             exact(second_) - v, at->second);
  if (!t) return std::nullopt;
  if (*t == 0) return from.exact();
  if (*t == 1) return to.exact();
  return Point{p.x + *t * along.x, p.y + *t * along.y};
}

double ResolvingCone::squared_bound(const FilteredPoint& from, const FilteredPoint& to) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::optional<Sides> at = sides(from, to);
  if (!at) return infinity;
  const At<Interval> v = enclosed(apex_), p = enclosed(from), along = enclosed(to) - p;
  const auto t = nearest_parameter<Interval>(p - v, along, enclosed(first_) - v, at->first,
                                             enclosed(second_) - v, at->second);
  if (!t) return infinity;
  const At<Interval> foot{p.x - v.x + *t * along.x, p.y - v.y + *t * along.y};
  return std::max(0.0, dot(foot, foot).lower());
}

std::optional<ResolvingCone> resolving_cone(const FilteredPoint& at,
                                            const std::vector<WallRay>& walls) {
  for (const WallRay& first : walls) {
    if (!first.interior_after) continue;
    // More than half a turn follows a wall iff every other wall lies to its right.
    const WallRay* second = nullptr;
    const bool is_wide = std::ranges::all_of(walls, [&](const WallRay& other) {
      if (&other == &first) return true;
      if (orientation(at, first.to, other.to) >= 0) return false;
      if (second == nullptr || orientation(at, second->to, other.to) < 0) second = &other;
      return true;
    });
    if (is_wide && second != nullptr) return ResolvingCone(at, first.to, second->to);
  }
  return std::nullopt;
}

}  // namespace minkref::inline plane
