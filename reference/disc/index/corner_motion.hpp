// How the vertices of P ⊕ ρD move with the radius, in doubles.
#pragma once

#include <cstdint>

#include "reference/disc/diagram/diagram_graph.hpp"

namespace minkref::inline disc {

/// A corner: a + (ρ - r) b + √(q0 + q1 ρ + q2 ρ²) c, where c is a unit vector, or 0 and q too.
/// Rounded: b, c, r and q by less than 2^-45 of them, a + (ρ - r) b by `error` beside.
struct CornerMotion {
  double ax = 0, ay = 0, r = 0, bx = 0, by = 0;
  double q0 = 0, q1 = 0, q2 = 0, cx = 0, cy = 0;
  double error = 0;
};

/// A joint, in front of an end of an edge: a + ρ b, each rounded by less than 2^-45 of it; `error`
/// is that of a, and of adding to it.
struct JointMotion {
  double ax = 0, ay = 0, bx = 0, by = 0;
  double error = 0;
};

/// Of the corner on a half of the diagram, in the frame of its curves; nothing where the radius is
/// the same all along.
CornerMotion corner_motion(const DiagramEvents& diagram, const DiagramGraph& graph,
                           std::uint32_t half);

JointMotion joint_motion(const Point& end, const Direction& normal);

}  // namespace minkref::inline disc
