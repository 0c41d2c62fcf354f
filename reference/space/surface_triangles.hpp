// A closed surface as triangles that know their neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reference/space/box_tree.hpp"
#include "reference/space/face_triangles.hpp"
#include "reference/space/polyhedron.hpp"
#include "reference/space/vertex_signs.hpp"

namespace minkref::inline space {

struct SurfaceTriangle {
  TriangleCorners corners;
  /// The triangle beyond the edge from corner k to corner k + 1.
  std::array<std::uint32_t, 3> beyond;
  std::uint32_t face;
  std::uint32_t shell;  ///< triangles from which one comes to each other over edges, from 0
};

/// Triangulates all faces of a closed 2-manifold with planar simple faces, face by face. Exact. O(n
/// log n) beside cutting the faces.
std::vector<SurfaceTriangle> surface_triangles(const std::vector<Face>& faces,
                                               const VertexSigns& signs);

/// Boxes around the triangles, in triangle order.
SpaceBoxTree box_tree(const std::vector<SurfaceTriangle>& triangles, const VertexSigns& signs);

}  // namespace minkref::inline space
