// Parallel segments and points beside a region.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"
#include "reference/plane/tight_passages.hpp"

namespace minkref::inline plane {

/// From one point to another, which does not come before it (x, then y); or a point.
struct BareSegment {
  Point from, to;
};

/// The closure of what parallel segments and points have beside a closed region: maximal pieces, in
/// the order of tight passages, without contacts. Exact. O(k (k + n)) for k segments and n edges.
std::vector<TightPassage> segments_beside(const PolygonSet& region,
                                          std::vector<BareSegment> segments);

}  // namespace minkref::inline plane
