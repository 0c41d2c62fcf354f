// Large faces cut into triangles in near-linear time.
#pragma once

#include <optional>
#include <vector>

#include "reference/space/face_triangles.hpp"

namespace minkref::inline space {

/// Returns triangles as `face_triangles` does, by a sweep that cuts the face into monotone pieces
/// (Garey, Johnson, Preparata and Tarjan 1978). Exact. O(n log n). Empty if the face is not planar
/// and simple, and only then.
std::optional<std::vector<TriangleCorners>> monotone_triangles(const Face& face,
                                                               const VertexSigns& signs);

}  // namespace minkref::inline space
