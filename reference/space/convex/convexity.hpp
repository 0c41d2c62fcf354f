// A convex surface's facets, and the convexity proof.
#pragma once

#include <vector>

#include "reference/space/integer_points.hpp"
#include "reference/space/polyhedron.hpp"
#include "reference/space/word_vectors.hpp"

namespace minkref::inline space {

/// Returns a valid surface's facets as rings: coplanar faces merged, and flat vertices (inside a
/// facet or an edge) dropped. `points` holds the vertices over one denominator. Throws BadInput
/// ("not-convex"), which names a face and, if one exists, a vertex above the face's plane. Exact.
/// O(n log n).
///
/// Why the surface is convex: neighbours of a facet lie strictly below its plane; a point o is
/// strictly below all planes; and a ray from o through the inside of one triangle of one facet
/// meets no other. So the surface, which lies around o facing outwards everywhere, lies around it
/// once, and a locally convex surface that does is the boundary of a convex set (Mehlhorn et al.,
/// "Checking geometric programs", 1999, Sec. 2).
std::vector<Face> certified_convex_facets(const Polyhedron& surface,
                                          const std::vector<IntegerVector>& points);

/// Certifies that any surface bounds a convex body with each facet one face and no flat vertex:
/// closed, planar, strictly convex at all vertices of all faces and at all edges, and as proven
/// above. `points` holds the vertices, each axis over a separate denominator. Throws BadInput for
/// any other surface. Exact. O(n log n).
void require_strictly_convex(const Polyhedron& surface, const std::vector<IntegerVector>& points);
void require_strictly_convex(const Polyhedron& surface, const std::vector<WordVector>& points);

}  // namespace minkref::inline space
