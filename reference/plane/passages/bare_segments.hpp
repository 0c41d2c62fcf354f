// Segments and points beside a region.
#pragma once

#include <vector>

#include "reference/plane/lines.hpp"
#include "reference/plane/tight_passages.hpp"

namespace minkref::inline plane {

/// The closure of what segments and points have beside a closed region: maximal pieces, in the
/// order of tight passages, without contacts. Exact. O(k (k + n)) for k segments and n edges.
std::vector<TightPassage> segments_beside(const PolygonSet& region,
                                          std::vector<BareSegment> segments);

}  // namespace minkref::inline plane
