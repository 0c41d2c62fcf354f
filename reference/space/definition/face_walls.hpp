// A surface's faces as convex polygons, and their planes.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/definition/corner.hpp"

namespace minkref::inline space {

/// A part of a face; the solid lies below `planes[cut]`.
struct Wall {
  std::uint32_t cut;
  CornerRing ring;
};

/// Planes 2 k and 2 k + 1 are the same with opposite normals.
struct FaceWalls {
  std::vector<CuttingPlane> planes;
  std::vector<Wall> walls;
};

/// Cuts faces that are not convex into triangles. Exact. O(n log n), and O(k^2) for such a face
/// with k corners.
FaceWalls face_walls(const Polyhedron& surface);

}  // namespace minkref::inline space
