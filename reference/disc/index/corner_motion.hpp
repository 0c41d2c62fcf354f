// How the vertices of P ⊕ ρD move with the radius, in doubles.
#pragma once

#include <cstdint>

#include "reference/disc/diagram/diagram_graph.hpp"

namespace minkref::inline disc {

/// A corner at the radius ρ: with w = ρ - r it is at a + w b + √(w (k0 + k1 w)) c, where c is a
/// unit vector, or 0 and k0 and k1 too. r is the sum of two doubles, so that w is right where ρ is
/// almost r: corners between walls that are nearly parallel are fast, and others start with a root.
/// Rounded: b, k0, k1 and c by less than 2^-48 of them, r by less than 2^-100; the rest, that of a,
/// is `error`.
struct CornerMotion {
  double ax = 0, ay = 0, r = 0, r_low = 0, bx = 0, by = 0;
  double k0 = 0, k1 = 0, cx = 0, cy = 0;
  double error = 0;
};

/// A joint, in front of an end of an edge: a + ρ b, each rounded by less than 2^-48 of it; `error`
/// is that of a, and of adding to it.
struct JointMotion {
  double ax = 0, ay = 0, bx = 0, by = 0;
  double error = 0;
};

/// The motion of the corner on a half of the diagram, in the frame of its curves; nothing where the
/// radius is the same all along.
CornerMotion corner_motion(const DiagramEvents& diagram, const DiagramGraph& graph,
                           std::uint32_t half);

/// The same corner at one radius, by its square in the frame: exact.
RootPoint corner_at(const DiagramEvents& diagram, const DiagramGraph& graph, std::uint32_t half,
                    const Rational& squared_radius);

JointMotion joint_motion(const Point& end, const Direction& normal);

}  // namespace minkref::inline disc
