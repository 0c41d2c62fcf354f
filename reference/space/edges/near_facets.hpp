// Pairs of facets that may matter to each other's carriers.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/edges/convolution_facets.hpp"

namespace minkref::inline space {

using NearLists = std::vector<std::vector<std::uint32_t>>;

/// For each facet the facets near it, ascending. Leaves out only pairs that a plane separates, and
/// pairs that share no more than a corner of both, or in one plane no more than a point: such a
/// facet cuts no carrier of the other. Near-linear where few facets are near each other in more
/// than a corner, as in fans; O(n^2) at worst. Can be interrupted.
NearLists near_lists(const std::vector<ConvolutionFacet>& facets, SignCounts& signs);

}  // namespace minkref::inline space
