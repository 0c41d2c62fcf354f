// Triangle meshes that every reader accepts: closed and manifold by vertex number.
#pragma once

#include "reference/space/polyhedron.hpp"
#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// The boundary as triangles with positive area, turned outwards. By vertex number every edge has
/// two triangles, which run along the edge either way, and the triangles about a vertex form one
/// fan: `validate` accepts the mesh. Where the set touches itself, faces go on across the interior,
/// and each fan has its own vertex at the same place; an edge that would still have four triangles
/// is cut at the middle. No vertex lies inside an edge or a triangle, except where the set touches
/// itself. Exact. O(n^2) for a face's vertices.
Polyhedron manifold_mesh(const SurfaceEdges& surface);

/// Cuts a polyhedron's faces into triangles with positive area along diagonals, on the same
/// vertices; a diagonal that shares both ends with an edge elsewhere is cut at the middle. The
/// result is closed, manifold and turned like the polyhedron. Exact. O(n log n). Throws BadInput
/// ("not-representable") for a face that is not planar and simple.
Polyhedron cut_into_triangles(const Polyhedron& polyhedron);

}  // namespace minkref::inline space
