// Points with bounds, as clusters take them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/near/separation.hpp"
#include "reference/space/edges/vectors.hpp"

namespace minkref::inline space {

/// The same points in the same order. Linear.
inline std::vector<NearPoint> near_points(const std::vector<BoundedVector>& points) {
  double most = 0;
  for (const BoundedVector& p : points) {
    for (const BoundedDouble& c : p) most = std::max(most, std::abs(c.value));
  }
  std::vector<NearPoint> result;
  result.reserve(points.size());
  for (const BoundedVector& p : points) {
    NearPoint& at = result.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      at.low[k] = p[k].value;
      // Wide enough to stay above zero when all is scaled.
      if (p[k].error > 0) at.width = std::max(at.width, p[k].error + most * 0x1p-200);
    }
  }
  return result;
}

}  // namespace minkref::inline space
