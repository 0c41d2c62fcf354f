// Convex bodies that cover the seams of the convex pieces of a solid.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Convex polyhedra inside of a valid solid whose interiors, together with those of its convex
/// pieces, cover its interior: also the points at which pieces meet. A set with a volume meets the
/// interior of a piece wherever it meets the interior of the solid; a point, a segment or a plane
/// polygon may lie in a seam. Where two pieces share a part of a face, this part is the middle of a
/// double cone; an edge of such a part, cut where other edges cross it or the surface meets it, is
/// the axis of a double cone; an end of these edges, unless it is on the surface, is the middle of
/// one. Exact. O(k^2) for k pieces and the edges between them.
std::vector<Polyhedron> seam_covers(const Polyhedron& solid, const std::vector<Polyhedron>& pieces);

}  // namespace minkref::inline space
