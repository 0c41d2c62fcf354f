// From the operands to the bytes of an index.
#pragma once

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/polygon_set.hpp"
#include "reference/scalespace/build_options.hpp"
#include "reference/scalespace/index_image.hpp"

namespace minkref {

/// Of a closed window. Exact; the same bytes for any number of threads. See ScaleSpaceIndex.
IndexImage index_image(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                       const BuildOptions& options);

}  // namespace minkref
