// The sum as a polyhedron: coplanar facets become one facet, with the summed faces of P and Q as
// parents.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/convex/dynamic_convex_sum.hpp"

namespace minkref::inline space {

/// A facet of the sum with the normal n is F_P(n) ⊕ F_Q(n), the faces of S P and Q farthest along
/// n: a vertex, the two ends of an edge, or the vertices of a facet, in ascending order.
struct FacetParents {
  std::vector<std::uint32_t> P, Q;
  friend bool operator==(const FacetParents&, const FacetParents&) = default;
};

/// Vertices come in lexicographic order, facets as strictly convex rings that start at the least
/// vertex, in ascending order: the canonical form (docs/definitions.md).
struct ConvexSum {
  Polyhedron surface;
  std::vector<SumVertices::Pair> vertex_parents;  ///< each vertex is s p + q for one pair only
  std::vector<FacetParents> facet_parents;
};

/// Builds the polyhedron from the pairs compatible at this scaling. The result is certified: valid,
/// closed, convex, no two coplanar facets, no flat vertex (convexity.hpp); a failure throws
/// std::logic_error. Exact. O(k log k).
ConvexSum surface_of(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const Compatibility& compatibility);

ConvexSum surface_of(const DynamicConvexSum& sum);

}  // namespace minkref::inline space
