// The sum of two operands without area, points and segments.
#pragma once

#include <vector>

#include "reference/plane/lines.hpp"
#include "reference/plane/tight_passages.hpp"

namespace minkref::inline plane {

/// The parts without area of `sP + Q` beside its region, the closure of the interior: the sums of
/// parallel segments and of points, as maximal pieces in the order of tight passages, without
/// contacts. P and Q: valid points and segments. `region`: of minkowski_sum(P, Q, scale). Exact.
/// O(m n + k (k + r)) for k flat sums and r edges of the region.
std::vector<TightPassage> sum_remnants(const PolygonSet& P, const PolygonSet& Q,
                                       const Rational& scale, const PolygonSet& region);

}  // namespace minkref::inline plane
