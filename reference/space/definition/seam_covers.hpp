// Convex bodies that cover the seams between a solid's convex pieces.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Returns convex polyhedra inside a valid solid whose interiors, together with the convex pieces'
/// interiors, cover the solid's interior: also the points where pieces meet. A set with a volume
/// meets a piece's interior wherever the set meets the solid's interior; a point, a segment or a
/// plane polygon may lie along a seam. Each common part of two pieces' faces is the middle of a
/// double cone; each edge of such a part, cut at crossing edges and at the surface, is the axis of
/// a double cone; each end of these edges, unless on the surface, is the middle of one. Exact.
/// O(k^2) for k pieces and the edges between them.
std::vector<Polyhedron> seam_covers(const Polyhedron& solid, const std::vector<Polyhedron>& pieces);

}  // namespace minkref::inline space
