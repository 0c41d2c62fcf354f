// Whether the interiors of convex bodies that meet at a point leave a direction open.
#pragma once

#include <vector>

#include "reference/space/integer_points.hpp"

namespace minkref::inline space {

/// The normals of a body's planes through a boundary point: near this point the body is the set
/// below all these planes.
using Cone = std::vector<IntegerVector>;

/// Whether each direction at right angles to `axis`, in turns about it, leads into the interior of
/// some cone; all normals must be at right angles to the axis. Exact. Cubic at worst.
bool cover_all_about(const IntegerVector& axis, const std::vector<Cone>& cones);

/// Whether each direction in space leads into the interior of some cone. Exact. O(n^2) rays for n
/// planes, each against all cones.
bool cover_all(const std::vector<Cone>& cones);

}  // namespace minkref::inline space
