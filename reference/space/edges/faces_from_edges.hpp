// Faces from the edges around them.
#pragma once

#include <vector>

#include "reference/space/edges/boundary_edges.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// The set whose boundary has these edges, its coordinates divided by the denominator. Exact.
/// std::logic_error where the edges in a plane do not close.
PolyhedralSet faces_from_edges(const std::vector<BoundaryEdge>& edges,
                               const std::vector<ConvolutionFacet>& facets,
                               const Integer& denominator);

}  // namespace minkref::inline space
