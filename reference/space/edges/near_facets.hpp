// Pairs of facets near enough to cut each other's carriers.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/edges/convolution_facets.hpp"

namespace minkref::inline space {

using NearLists = std::vector<std::vector<std::uint32_t>>;

/// For each facet the facets near it, ascending. Leaves out only separated pairs, pairs with a
/// single common corner, and coplanar pairs with a single common point: such facets cut none of the
/// carriers. O(n log n + m) for m pairs with overlapping boxes, fewer for fans. Can be interrupted.
NearLists near_lists(const std::vector<ConvolutionFacet>& facets, SignCounts& signs);

}  // namespace minkref::inline space
