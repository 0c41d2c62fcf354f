// Faces as triangles, for formats that have no others.
#pragma once

#include <optional>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref {

/// Cuts a planar simple face into triangles of positive area along diagonals, turned as the face
/// is; the face need not be convex, and may have straight angles. None where this is not possible:
/// every planar simple face can be cut. Exact. O(n log n).
std::optional<std::vector<Face>> triangles_of(const Face& face,
                                              const std::vector<SpacePoint>& vertices);

}  // namespace minkref
