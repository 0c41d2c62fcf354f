// Meshes of triangles that every reader takes: closed and manifold by the numbers of their
// vertices.
#pragma once

#include "reference/space/polyhedron.hpp"
#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// The boundary as triangles of positive area, turned outwards. By the numbers of vertices every
/// edge has two triangles, which run along it either way, and the triangles about a vertex are one
/// fan: `validate` takes the mesh. Where the set touches itself, faces go on across the interior,
/// and each fan has a vertex of its own at the same place; an edge that would still have four
/// triangles is cut in its middle. No vertex lies inside of an edge or a triangle, unless in a
/// place where the set touches itself. Exact. O(n^2) for the vertices of one face.
Polyhedron manifold_mesh(const SurfaceEdges& surface);

/// The faces of a polyhedron cut into triangles of positive area along diagonals, with its
/// vertices; a diagonal whose ends are those of an edge elsewhere is cut in its middle. Closed,
/// manifold and turned as the polyhedron is. Exact. O(n log n). BadInput ("not-representable") for
/// a face that is not planar and simple.
Polyhedron cut_into_triangles(const Polyhedron& polyhedron);

}  // namespace minkref::inline space
