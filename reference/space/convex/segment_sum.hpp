// The sum of a convex polyhedron and a segment.
#pragma once

#include "reference/space/convex/convex_sum.hpp"

namespace minkref::inline space {

/// Returns S P ⊕ [a, b] as canonical form, certified like surface_of. Among the parents, Q's
/// vertices are a (0) and b (1). Facets facing the direction from a to b lie at b, the others at a,
/// and the edges between the two kinds sweep parallelograms. Throws BadInput ("bad-scale", and
/// "zero-length-edge" if a equals b). Exact. O(m log m).
ConvexSum sum_with_segment(const ConvexPolyhedron& P, const Scaling& scaling, const SpacePoint& a,
                           const SpacePoint& b);

}  // namespace minkref::inline space
