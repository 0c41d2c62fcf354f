// The faces of a surface as convex polygons, and the planes they lie in.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/definition/corner.hpp"

namespace minkref::inline space {

/// A part of a face; the solid is below `planes[cut]`.
struct Wall {
  std::uint32_t cut;
  CornerRing ring;
};

/// Planes 2 k and 2 k + 1 are the same with opposite normals.
struct FaceWalls {
  std::vector<CuttingPlane> planes;
  std::vector<Wall> walls;
};

/// Faces that are not convex are cut into triangles. Exact. O(n log n), and O(k^2) for such a face
/// of k corners.
FaceWalls face_walls(const Polyhedron& surface);

}  // namespace minkref::inline space
