// What of the facets of convex bodies is on the boundary of their union.
#pragma once

#include <vector>

#include "reference/space/definition/summand.hpp"

namespace minkref::inline space {

/// The boundary of the union of the bodies, which may overlap in any way. Exact.
PolyhedralSet boundary_of_union(const std::vector<SumBody>& bodies);

}  // namespace minkref::inline space
