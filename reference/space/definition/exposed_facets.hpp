// The parts of the facets of convex bodies on the boundary of the union of the bodies.
#pragma once

#include <vector>

#include "reference/space/definition/summand.hpp"

namespace minkref::inline space {

/// Convex parts of a convex polygon, of which the body covers some: what is outside of each of its
/// planes in turn. Only the polygon itself where nothing of it is inside of all of them.
std::vector<CornerRing> parts_outside(const CornerRing& ring, const SumBody& body);

/// The boundary of the union of the bodies, which may overlap in any way. Exact.
PolyhedralSet boundary_of_union(const std::vector<SumBody>& bodies);

}  // namespace minkref::inline space
