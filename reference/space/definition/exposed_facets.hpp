// The exposed parts of convex bodies' facets: the parts on the boundary of the bodies' union.
#pragma once

#include <vector>

#include "reference/space/definition/summand.hpp"

namespace minkref::inline space {

/// Cuts from a convex polygon the convex parts outside each plane of the body, plane by plane.
/// Returns only the polygon itself if no part lies inside all planes.
std::vector<CornerRing> parts_outside(const CornerRing& ring, const SumBody& body);

/// The boundary of the union of the bodies, which may overlap in any way. Exact.
PolyhedralSet boundary_of_union(const std::vector<SumBody>& bodies);

}  // namespace minkref::inline space
