// Convex hulls of a few integer points, by all triples of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::fuzzing {

/// Below 2^15 in magnitude.
using LatticePoint = std::array<std::int64_t, 3>;

/// One face for each facet, its corners only; the empty set where all points lie in one plane.
/// O(n^4).
Polyhedron hull_of_points(std::vector<LatticePoint> points);

/// Every face cut into triangles from its first corner: that of a convex body.
Polyhedron triangulated(const Polyhedron& body);

}  // namespace minkref::fuzzing
