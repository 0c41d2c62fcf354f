#include "reference/plane/decomposition/resolving_cone.hpp"

#include <algorithm>

namespace minkref::inline plane {
namespace {

Rational cross(const Point& at, const Point& a, const Point& b) {
  return (a.x - at.x) * (b.y - at.y) - (a.y - at.y) * (b.x - at.x);
}

/// A part of a segment, in parameters from 0 to 1.
struct Stretch {
  Rational low = 0, high = 1;

  /// Keeps the parameters with a value >= 0; the value grows or falls linearly between both ends.
  void keep(const Rational& at_0, const Rational& at_1) {
    if (at_0 < 0 && at_1 > at_0) low = std::max(low, Rational(at_0 / (at_0 - at_1)));
    if (at_1 < 0 && at_0 > at_1) high = std::min(high, Rational(at_0 / (at_0 - at_1)));
  }
};

}  // namespace

std::optional<Point> ResolvingCone::nearest(const FilteredPoint& from,
                                            const FilteredPoint& to) const {
  // The cone: left of the line from the apex to `first`, right of the line to `second`.
  const int from_1 = orientation(apex_, first_, from), to_1 = orientation(apex_, first_, to);
  if (from_1 < 0 && to_1 < 0) return std::nullopt;
  const int from_2 = orientation(apex_, second_, from), to_2 = orientation(apex_, second_, to);
  if (from_2 > 0 && to_2 > 0) return std::nullopt;
  const Point &v = apex_.exact(), &p = from.exact(), &q = to.exact();
  Stretch inside;
  if (from_1 < 0 || to_1 < 0) {
    inside.keep(cross(v, first_.exact(), p), cross(v, first_.exact(), q));
  }
  if (from_2 > 0 || to_2 > 0) {
    inside.keep(cross(v, p, second_.exact()), cross(v, q, second_.exact()));
  }
  if (inside.low > inside.high) return std::nullopt;
  const Rational dx = q.x - p.x, dy = q.y - p.y;
  const Rational foot = ((v.x - p.x) * dx + (v.y - p.y) * dy) / (dx * dx + dy * dy);
  const Rational t = std::clamp(foot, inside.low, inside.high);
  if (t == 0) return p;
  if (t == 1) return q;
  return Point{p.x + t * dx, p.y + t * dy};
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
