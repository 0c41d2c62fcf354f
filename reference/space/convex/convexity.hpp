// The facets of a convex surface, and the proof that it is one.
#pragma once

#include <vector>

#include "reference/space/integer_points.hpp"
#include "reference/space/polyhedron.hpp"
#include "reference/space/word_vectors.hpp"

namespace minkref::inline space {

/// The rings of the facets of a valid surface, its coplanar faces merged and its flat vertices
/// dropped: those inside a facet and those inside an edge. `points` are its vertices over one
/// denominator. Throws BadInput ("not-convex"), which names a face and a vertex above its plane
/// where there is one. Exact. O(n log n).
///
/// Why it is convex: neighbours of a facet lie strictly below its plane; a point o is strictly
/// below all planes; and a ray from o through the inside of one triangle of one facet meets no
/// other. So the surface, which lies around o facing outwards everywhere, lies around it once, and
/// a locally convex surface that does is the boundary of a convex set (Mehlhorn et al., "Checking
/// geometric programs", 1999, Sec. 2).
std::vector<Face> certified_convex_facets(const Polyhedron& surface,
                                          const std::vector<IntegerVector>& points);

/// Whether any surface is the boundary of a convex body with each facet one face and no flat
/// vertex: closed, planar, strictly convex at all vertices of all faces and at all edges, and the
/// above. `points` are its vertices, each axis over a denominator of its own. Throws BadInput where
/// it is not. Exact. O(n log n).
void require_strictly_convex(const Polyhedron& surface, const std::vector<IntegerVector>& points);
void require_strictly_convex(const Polyhedron& surface, const std::vector<WordVector>& points);

}  // namespace minkref::inline space
