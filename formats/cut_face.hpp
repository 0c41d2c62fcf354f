// Faces as triangles, for formats without other faces.
#pragma once

#include <optional>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref {

/// Cuts a planar simple face into triangles of positive area along diagonals, with the face's
/// orientation; the face may be concave, and may have straight angles. None if no cutting exists:
/// every planar simple face has a cutting. Exact. O(n log n).
std::optional<std::vector<Face>> triangles_of(const Face& face,
                                              const std::vector<SpacePoint>& vertices);

}  // namespace minkref
