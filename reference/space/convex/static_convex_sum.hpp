// The sum of convex polyhedra from scratch, in two ways.
#pragma once

#include "reference/space/convex/compatibility.hpp"

namespace minkref::inline space {

/// The overlay by traversal: one facet's vertex is looked for from anywhere, that of each neighbour
/// from there, and each edge's chain is walked. About linear in the facets and the ee-pairs on
/// bodies whose facets are not much larger than each other.
Compatibility by_traversal(const Contacts& contacts);

/// Every facet against every vertex and every edge against every edge, as the paper's comparison
/// does: a vertex is compatible with a facet where none of its edges rises, and two edges where
/// each separates the facets of the other, on the same side of the sphere. O(mn).
Compatibility by_brute_force(const Contacts& contacts);

}  // namespace minkref::inline space
