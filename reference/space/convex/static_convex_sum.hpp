// The sum of convex polyhedra from scratch, by two methods.
#pragma once

#include "reference/space/convex/compatibility.hpp"

namespace minkref::inline space {

/// Builds the overlay by traversal: searches one facet's vertex from anywhere, each neighbour's
/// vertex from there, and walks each edge's chain. About linear in facets and ee-pairs on bodies
/// with facets of similar size.
Compatibility by_traversal(const Contacts& contacts);

/// Compares every facet with every vertex and every edge with every edge, as the paper does: a
/// vertex is compatible with a facet if no edge at the vertex rises, and two edges are compatible
/// if each separates the other's facets, on the same side of the sphere. O(mn).
Compatibility by_brute_force(const Contacts& contacts);

}  // namespace minkref::inline space
