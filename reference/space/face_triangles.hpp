// Faces cut into triangles along diagonals.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/space/polyhedron.hpp"
#include "reference/space/vertex_signs.hpp"

namespace minkref::inline space {

/// A triangle's vertex numbers.
using TriangleCorners = std::array<std::uint32_t, 3>;

/// Cuts a planar simple face of at least three vertices into triangles of positive area along
/// diagonals, turned as the face is; the face need not be convex, and may have straight angles.
/// None where this is not possible: every planar simple face can be cut. Exact. O(n log n).
std::optional<std::vector<TriangleCorners>> face_triangles(const Face& face,
                                                           const VertexSigns& signs);

}  // namespace minkref::inline space
