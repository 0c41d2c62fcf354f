// The scales at which the answer for a path may change: where contacts come to the path.
#pragma once

#include <vector>

#include "reference/space/definition/exact_vectors.hpp"

namespace minkref::inline space {

/// Scales s > 0 at which a vertex of x + sR and an edge of O, or the other way round, have a common
/// point for some x of the path, and did not for all s. Also scales at which, for a path vertex x,
/// a vertex lies on a face with all edges at it on the outer side, or two edges cross with their
/// faces on either side of their plane. Between two of these nothing changes (docs/paths.md).
/// Either operand may be thin. Exact. O(m n k) for m and n edges and k segments.
std::vector<Rational> contact_scales(const Polyhedron& part, const Polyhedron& obstacles,
                                     const std::vector<SpacePoint>& path);

}  // namespace minkref::inline space
