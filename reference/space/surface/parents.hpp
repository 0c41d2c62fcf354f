// Which facets of the convolution the faces of a sum come from.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/edges/convolution_facets.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// For each plane region of a sum, the facets that lie in its plane, turned the same way, and have
/// area in common with the region: ascending numbers of `facets`, whose corners are over
/// `denominator`. A plane may have several regions, which follow each other.
/// Exact. O((f + n) log n + k) for f facets and k pairs of a facet and an edge of a region in one
/// plane whose boxes meet.
std::vector<std::vector<std::uint32_t>> parents(const PolyhedralSet& set,
                                                const std::vector<ConvolutionFacet>& facets,
                                                const Integer& denominator);

}  // namespace minkref::inline space
