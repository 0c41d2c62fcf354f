// The planes of a polyhedron's faces, over rationals.
#pragma once

#include <vector>

#include "reference/space/definition/exact_vectors.hpp"

namespace minkref::inline space {

/// The points with normal · x = offset; the solid lies below, beside the face.
struct FacePlane {
  SpacePoint normal;
  Rational offset;
};

/// Newell's normals: twice the area of each face. Exact. Linear.
inline std::vector<FacePlane> face_planes(const Polyhedron& polyhedron) {
  std::vector<FacePlane> planes;
  const std::vector<SpacePoint>& v = polyhedron.vertices;
  for (const Face& face : polyhedron.faces) {
    SpacePoint normal;
    for (std::size_t k = 2; k < face.size(); ++k) {
      normal = normal + cross(v[face[k - 1]] - v[face[0]], v[face[k]] - v[face[0]]);
    }
    planes.push_back({normal, dot(normal, v[face[0]])});
  }
  return planes;
}

}  // namespace minkref::inline space
