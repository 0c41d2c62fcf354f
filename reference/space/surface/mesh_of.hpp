// A set in space as a mesh.
#pragma once

#include "reference/space/polyhedron.hpp"
#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// How faces are written.
enum class MeshFaces : std::uint8_t {
  polygons,  ///< as simple polygons where they are such, without holes; else as triangles
  triangles
};

/// The faces of the mesh of each face of the surface.
std::vector<std::vector<Face>> mesh_faces(const SurfaceEdges& surface,
                                          MeshFaces faces = MeshFaces::polygons);

/// The boundary as faces with common vertices, turned outwards. It is closed: of the faces at an
/// edge as many run along it one way as the other. It conforms: two edges are the same or meet at
/// common vertices only, and neither edges nor vertices lie in the inside of a face. Angles of
/// polygons may be straight. Where the set is not manifold the mesh is not, and `validate` refuses
/// it. Vertices ascend. Exact. O(n^2) for the vertices of one face.
Polyhedron mesh_of(const SurfaceEdges& surface, MeshFaces faces = MeshFaces::polygons);

}  // namespace minkref::inline space
