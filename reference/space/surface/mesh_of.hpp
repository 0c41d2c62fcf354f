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

/// The mesh faces for each face of the surface.
std::vector<std::vector<Face>> mesh_faces(const SurfaceEdges& surface,
                                          MeshFaces faces = MeshFaces::polygons);

/// The boundary as faces with common vertices, turned outwards. The mesh is closed: at each edge as
/// many faces run one way as the other. The mesh conforms: two edges are equal or meet at common
/// vertices only, and neither edges nor vertices lie inside a face. Polygon angles may be straight.
/// A set that is not manifold gives such a mesh too, and `validate` refuses it. Vertices ascend.
/// Exact. O(n^2) for a face's vertices.
Polyhedron mesh_of(const SurfaceEdges& surface, MeshFaces faces = MeshFaces::polygons);

}  // namespace minkref::inline space
