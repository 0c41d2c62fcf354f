// Conditions on all faces of a polyhedron together: none crosses or covers another, and shells nest
// as the boundary of one set.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"
#include "reference/space/surface_triangles.hpp"
#include "reference/space/vertex_signs.hpp"

namespace minkref::inline space {

/// A closed 2-manifold of planar simple faces, made ready for the two checks below.
struct SearchedSurface {
  const Polyhedron& polyhedron;
  const Integer denominator;  ///< of the points of `signs`
  VertexSigns signs;
  std::vector<SurfaceTriangle> triangles;
  SpaceBoxTree tree;
};

/// Refuses (BadInput) a surface that crosses itself ("self-intersection") or covers a part of
/// itself ("overlapping-faces"); names two faces, not always the first ones, and a point that both
/// have. Contact at points and along lines is no fault where nothing passes through. Exact.
/// O(n log n) where few boxes around triangles overlap, near-linear where slivers and fans make
/// many overlap (reference/near/), O(n^2) at worst; can be interrupted.
void refuse_crossing_faces(const SearchedSurface& surface);

/// Refuses a surface that passes the above but does not have the unbounded outside, or a hollow,
/// just off each of its shells. Codes "shell-nesting" (a shell inside the material) and
/// "wrong-orientation" (a shell inside out that hollows out nothing). Exact. A ray for each shell.
void refuse_wrong_nesting(const SearchedSurface& surface);

}  // namespace minkref::inline space
