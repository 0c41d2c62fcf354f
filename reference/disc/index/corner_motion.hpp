// How the vertices of P ⊕ ρD move with the radius, as doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "reference/disc/diagram/diagram_graph.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {

/// A point, off by at most `error` along each axis.
struct BoundedPoint {
  double x, y, error;
};

/// A corner at the radius ρ: with w = ρ - r, the corner lies at a + w b + √(w (k0 + k1 w)) c, where
/// c is a unit vector, or c, k0 and k1 are all 0. r is the sum of two doubles, so that w stays
/// right for ρ close to r: corners between nearly parallel walls are fast, and others start with a
/// root. Rounding errors: b, k0, k1 and c by less than 2^-48 of each, r by less than 2^-100;
/// `error` bounds the rest, the error of a.
struct CornerMotion {
  double ax = 0, ay = 0, r = 0, r_low = 0, bx = 0, by = 0;
  double k0 = 0, k1 = 0, cx = 0, cy = 0;
  double error = 0;
  static constexpr double rounding = 0x1p-48;
};

/// A joint, in front of an edge's end: a + ρ b, both rounded by less than 2^-48 of each; `error`
/// bounds the errors of a, and of adding to a.
struct JointMotion {
  double ax = 0, ay = 0, bx = 0, by = 0;
  double error = 0;
};

/// The motion of the corner on a half of the diagram, within the curves' frame; empty if the radius
/// stays the same all along.
CornerMotion corner_motion(const DiagramEvents& diagram, const DiagramGraph& graph,
                           std::uint32_t half);

/// The corner at a radius known up to `off`, in the standard environment of doubles.
inline BoundedPoint corner_of(const CornerMotion& m, const TwoDoubles& rho, double off) {
  constexpr double rounding = CornerMotion::rounding;
  constexpr double turn = 1.5;  // at least the sum of both coordinates of a unit vector
  const double way = ((rho.high - m.r) - m.r_low) + rho.low;
  const double way_off = off + 0x1p-50 * std::abs(way) + 0x1p-98 * (rho.high + m.r);
  const double square = way * (m.k0 + m.k1 * way);
  const double root = std::sqrt(std::max(square, 0.0));
  // The square's error; the root errs by this error over the root, or by its square root.
  const double square_off =
      (m.k0 + 2.1 * m.k1 * std::abs(way)) * way_off + rounding * std::abs(square) + 0x1p-1000;
  const double root_off = square > square_off ? 2 * square_off / root : 2 * std::sqrt(square_off);
  const double speed = std::abs(m.bx) + std::abs(m.by);
  return {m.ax + way * m.bx + root * m.cx, m.ay + way * m.by + root * m.cy,
          m.error + 0x1p-50 * (std::abs(m.ax) + std::abs(m.ay)) +
              rounding * (std::abs(way) * speed + root * turn) + way_off * speed + root_off * turn};
}

/// Whether the farther end of a half lies on the left of a point, looked at against a vector: 1 or
/// -1; 0 in line with it. Exact.
int side_of_end(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t half,
                const Point& from, const Direction& along);

/// The same corner at one radius, given by its square within the frame: exact.
RootPoint corner_at(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t half,
                    const Rational& squared_radius);

JointMotion joint_motion(const Point& end, const Direction& normal);

}  // namespace minkref::inline disc
