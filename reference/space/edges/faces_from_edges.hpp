// Faces from surrounding edges.
#pragma once

#include <vector>

#include "reference/space/edges/boundary_edges.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// Returns the set with these boundary edges, coordinates divided by the denominator. Exact. Throws
/// std::logic_error if the edges within a plane do not close.
PolyhedralSet faces_from_edges(const std::vector<BoundaryEdge>& edges,
                               const std::vector<ConvolutionFacet>& facets,
                               const Integer& denominator);

}  // namespace minkref::inline space
