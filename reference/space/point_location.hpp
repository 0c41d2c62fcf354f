// A point's location relative to a set in space: by the crossings of a ray, exactly.
#pragma once

#include "reference/plane/location.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// Exact. O(n) for each ray; the first ray nearly always decides, and 2n + 1 always do.
Location locate(const PolyhedralSet& set, const SpacePoint& point);

}  // namespace minkref::inline space
