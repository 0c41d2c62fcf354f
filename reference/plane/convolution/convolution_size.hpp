// A convolution's size, before the convolution exists.
#pragma once

#include <cstdint>

#include "reference/plane/convolution/between.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The edge count of the reduced or the full convolution. Exact. Takes the convolution's time, but
/// no memory for its edges.
std::uint64_t convolution_size(const PolygonSet& P, const PolygonSet& Q, bool full,
                               Between between = Between::half_open);

}  // namespace minkref::inline plane
