// From the operands to the bytes of an index.
#pragma once

#include "reference/build/build_options.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/index/index_image.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The index image of a closed window. Exact; the same bytes for any number of threads. See
/// ScaleIndex.
IndexImage index_image(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                       const BuildOptions& options);

}  // namespace minkref::inline plane
