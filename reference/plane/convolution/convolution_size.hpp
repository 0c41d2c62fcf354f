// How large a convolution is, before it is made.
#pragma once

#include <cstdint>

#include "reference/plane/convolution/between.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The number of edges of the reduced convolution, or of the full one. Exact. Takes the time of the
/// convolution, and no memory for its edges.
std::uint64_t convolution_size(const PolygonSet& P, const PolygonSet& Q, bool full,
                               Between between = Between::half_open);

}  // namespace minkref::inline plane
