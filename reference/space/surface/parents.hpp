// The facets of the convolution from which a sum's faces come.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/edges/convolution_facets.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// For each plane region of a sum, the facets within the same plane, turned the same way, that
/// share area with the region: ascending numbers of `facets`, whose corners are over `denominator`.
/// A plane may have several regions, which follow each other. Exact. O((f + n) log n + k) for f
/// facets and k coplanar pairs of a facet and a region's edge with overlapping boxes.
std::vector<std::vector<std::uint32_t>> parents(const PolyhedralSet& set,
                                                const std::vector<ConvolutionFacet>& facets,
                                                const Integer& denominator);

}  // namespace minkref::inline space
