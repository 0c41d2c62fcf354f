// The sum of a convex polyhedron and a segment.
#pragma once

#include "reference/space/convex/convex_sum.hpp"

namespace minkref::inline space {

/// S P ⊕ [a, b], in canonical form and certified as surface_of is. In the parents, Q's vertices are
/// a (0) and b (1). Facets that face the direction from a to b are at b, the others at a, and the
/// edges between the two kinds sweep parallelograms. Throws BadInput ("bad-scale", and
/// "zero-length-edge" where a and b are one point). Exact. O(m log m).
ConvexSum sum_with_segment(const ConvexPolyhedron& P, const Scaling& scaling, const SpacePoint& a,
                           const SpacePoint& b);

}  // namespace minkref::inline space
