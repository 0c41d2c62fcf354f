// Convex hulls of a few integer points, from all triples.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::fuzzing {

/// Below 2^15 in magnitude.
using LatticePoint = std::array<std::int64_t, 3>;

/// A face for each facet, with corners only; the empty set for coplanar points. O(n^4).
Polyhedron hull_of_points(std::vector<LatticePoint> points);

/// Cuts every face of a convex body into triangles from its first corner.
Polyhedron triangulated(const Polyhedron& body);

}  // namespace minkref::fuzzing
