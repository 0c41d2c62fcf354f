// The sum of polyhedra of any shape, by definition: the union of the convex pieces' sums.
#pragma once

#include <cstddef>

#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// Returns S P ⊕ Q for valid operands that do not cross themselves. One operand may be a point or a
/// segment; the sum with the empty set is empty. Throws BadInput ("bad-scale";
/// "degenerate-operands" if both are points or segments; like convex_pieces), and LimitExceeded
/// ("too-many-pairs") beyond `most_pairs_of_pieces`, before summing any pair.
///
/// The result is the union of the sums C over all pairs of convex pieces. A facet of one C, in the
/// plane n · x = d, lies on the boundary where no C covers the points just above: within the
/// interior of no C and within no facet with the opposite normal. So each C takes from the facet
/// the part below all planes of C, a plane that holds the facet counting as n says; the remaining
/// convex polygons are united plane by plane.
///
/// Exact. For k pairs of pieces with f facets each: O(k f) facets against the facets of the k
/// bodies whose boxes they meet. Some 50 KiB for each pair.
PolyhedralSet definition_sum(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling);

constexpr std::size_t most_pairs_of_pieces = 65'536;

}  // namespace minkref::inline space
