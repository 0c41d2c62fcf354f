#include "reference/space/definition/corner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace minkref::inline space {
namespace {

// Each number below is rounded once or twice and takes part in at most five operations: less than
// sixteen units of the last place. The absolute error covers losses below the least normal double.
const double relative_error = std::ldexp(1.0, -49);
const double absolute_error = std::ldexp(1.0, -500);

std::pair<std::size_t, std::size_t> axes_beside(std::size_t axis) {
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

/// Whether a, b, c turn to the left, seen along `axis`: the sign of a determinant.
int turn_of_corners(const SolidCorner& a, const SolidCorner& b, const SolidCorner& c,
                    std::size_t axis) {
  const auto [u, v] = axes_beside(axis);
  const double ax = a.rounded[u], ay = a.rounded[v], bx = b.rounded[u], by = b.rounded[v],
               cx = c.rounded[u], cy = c.rounded[v];
  const double turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  const double mx = std::abs(ax), my = std::abs(ay);
  const double x = mx + std::abs(bx), y = my + std::abs(by), xx = mx + std::abs(cx),
               yy = my + std::abs(cy);
  const double doubt = relative_error * (x * yy + y * xx) + absolute_error * (1 + x + y + xx + yy);
  if (turn > doubt) return 1;
  if (turn < -doubt) return -1;
  const IntegerVector &p = a.exact->point, &q = b.exact->point, &r = c.exact->point;
  const IntegerVector first{p[u], p[v], a.exact->weight}, second{q[u], q[v], b.exact->weight},
      third{r[u], r[v], c.exact->weight};
  return dot(first, cross(second, third)).sign();
}

}  // namespace

int compare_along(const SolidCorner& a, const SolidCorner& b, std::size_t axis) {
  if (a.rounded[axis] < b.rounded[axis]) return -1;
  if (a.rounded[axis] > b.rounded[axis]) return 1;
  if (a.exact == b.exact) return 0;
  const Integer difference =
      a.exact->point[axis] * b.exact->weight - b.exact->point[axis] * a.exact->weight;
  return difference.sign();
}

SolidCorner solid_corner(const IntegerVector& point, const Integer& weight) {
  const Integer divisor = gcd(gcd(point[0], point[1]), gcd(point[2], weight));
  const auto exact = std::make_shared<HomogeneousPoint>(HomogeneousPoint{
      {point[0] / divisor, point[1] / divisor, point[2] / divisor}, weight / divisor});
  SolidCorner corner{{}, exact};
  for (std::size_t k = 0; k < 3; ++k) {
    corner.rounded[k] = to_double(Rational(exact->point[k], exact->weight));
  }
  return corner;
}

SolidCorner solid_corner(const SpacePoint& point) {
  const IntegerPoints integers = integer_points({point});
  return solid_corner(integers.points[0], integers.denominator);
}

SpacePoint exact_point(const SolidCorner& corner) {
  const auto& [point, weight] = *corner.exact;
  return {Rational(point[0], weight), Rational(point[1], weight), Rational(point[2], weight)};
}

OrientedPlane reversed(const OrientedPlane& plane) {
  const IntegerVector& n = plane.normal;
  return {{-n[0], -n[1], -n[2]}, -plane.offset};
}

CuttingPlane::CuttingPlane(OrientedPlane plane) : plane_(std::move(plane)) {
  const Integer unit = denominator(plane_.offset);
  offset_ = numerator(plane_.offset);
  rounded_offset_ = to_double(plane_.offset);
  slack_ = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    normal_[k] = plane_.normal[k] * unit;
    rounded_normal_[k] = to_double(Rational(plane_.normal[k]));
    slack_ += std::abs(rounded_normal_[k]);
  }
  slack_ *= absolute_error;
}

Integer CuttingPlane::height(const HomogeneousPoint& point) const {
  return dot(normal_, point.point) - offset_ * point.weight;
}

int CuttingPlane::side(const SolidCorner& corner) const {
  const double x = rounded_normal_[0] * corner.rounded[0],
               y = rounded_normal_[1] * corner.rounded[1],
               z = rounded_normal_[2] * corner.rounded[2];
  const double above = x + y + z - rounded_offset_;
  const double doubt =
      relative_error * (std::abs(x) + std::abs(y) + std::abs(z) + std::abs(rounded_offset_)) +
      slack_;
  if (above > doubt) return 1;
  if (above < -doubt) return -1;
  return height(*corner.exact).sign();
}

SolidCorner CuttingPlane::meeting(const SolidCorner& a, const SolidCorner& b) const {
  // The heights have different signs, so both factors are positive.
  const Integer from_a = abs(height(*b.exact)), from_b = abs(height(*a.exact));
  IntegerVector point;
  for (std::size_t k = 0; k < 3; ++k) {
    point[k] = from_a * a.exact->point[k] + from_b * b.exact->point[k];
  }
  return solid_corner(point, from_a * a.exact->weight + from_b * b.exact->weight);
}

RingSides sides_of(const CornerRing& ring, const CuttingPlane& plane) {
  RingSides result;
  result.sides.reserve(ring.size());
  for (const SolidCorner& corner : ring) {
    const int side = plane.side(corner);
    result.sides.push_back(static_cast<std::int8_t>(side));
    result.above = result.above || side > 0;
    result.below = result.below || side < 0;
  }
  return result;
}

RingHalves halves(const CornerRing& ring, const RingSides& sides, const CuttingPlane& plane) {
  RingHalves result;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::size_t next = k + 1 == ring.size() ? 0 : k + 1;
    const int here = sides.sides[k], there = sides.sides[next];
    if (here <= 0) result.below.push_back(ring[k]);
    if (here >= 0) result.above.push_back(ring[k]);
    if (here * there >= 0) continue;
    const SolidCorner corner = plane.meeting(ring[k], ring[next]);
    result.below.push_back(corner);
    result.above.push_back(corner);
  }
  return result;
}

CornerRing convex_ring(std::vector<SolidCorner> points, std::size_t axis) {
  const auto [u, v] = axes_beside(axis);
  const auto compare = [u = u, v = v](const SolidCorner& a, const SolidCorner& b) {
    const int order = compare_along(a, b, u);
    return order != 0 ? order : compare_along(a, b, v);
  };
  std::sort(points.begin(), points.end(),
            [&](const SolidCorner& a, const SolidCorner& b) { return compare(a, b) < 0; });
  points.erase(
      std::unique(points.begin(), points.end(),
                  [&](const SolidCorner& a, const SolidCorner& b) { return compare(a, b) == 0; }),
      points.end());
  if (points.size() < 3) return points;
  CornerRing ring;
  const auto add = [&](const SolidCorner& corner, std::size_t least) {
    while (ring.size() >= least + 2 &&
           turn_of_corners(ring[ring.size() - 2], ring.back(), corner, axis) <= 0) {
      ring.pop_back();
    }
    ring.push_back(corner);
  };
  for (const SolidCorner& corner : points) add(corner, 0);
  const std::size_t least = ring.size() - 1;
  for (std::size_t k = points.size() - 1; k-- > 0;) add(points[k], least);
  ring.pop_back();
  return ring;
}

CornerRing convex_ring_about(std::vector<SolidCorner> points, const IntegerVector& normal) {
  const std::size_t axis = viewing_axis(normal);
  CornerRing ring = convex_ring(std::move(points), axis);
  // A view along the second axis mirrors the other two axes.
  if ((normal[axis] < 0) != (axis == 1)) std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace minkref::inline space
