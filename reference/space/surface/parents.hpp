// Which facets of the convolution the faces of a sum come from.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/edges/convolution_facets.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// Of each plane region of a sum the facets that lie in its plane, turned the same way, and have
/// area in common with it: ascending numbers of `facets`, whose corners are over `denominator`.
/// A plane may have several regions, which follow each other.
/// Exact. O((f + n) log n + k) for f facets and k pairs of a facet and an edge of a region in one
/// plane.
std::vector<std::vector<std::uint32_t>> parents(const PolyhedralSet& set,
                                                const std::vector<ConvolutionFacet>& facets,
                                                const Integer& denominator);

/// A facet by the vertices of the operands whose sums are its corners: a triangle and a vertex, a
/// vertex and a triangle, or two edges, each from its first vertex to its second. Triangles are
/// those into which faces are cut.
struct Parent {
  FacetKind kind;
  std::vector<std::uint32_t> of_P, of_Q;
};
/// The same for S P ⊕ Q, of operands that `edge_sum` takes. Exact. O(|P| |Q|) besides.
std::vector<std::vector<Parent>> parents(const PolyhedralSet& sum, const Polyhedron& P,
                                         const Polyhedron& Q, const Scaling& scaling);

}  // namespace minkref::inline space
