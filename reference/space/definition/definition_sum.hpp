// The sum of polyhedra of any shape from its definition: the union of the sums of convex pieces.
#pragma once

#include <cstddef>

#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// S P ⊕ Q, for valid operands that do not cross themselves. One of them may be a point or a
/// segment; the sum with the empty set is empty. Throws BadInput ("bad-scale";
/// "degenerate-operands" where both are points or segments; as convex_pieces does), and
/// LimitExceeded ("too-many-pairs") beyond `most_pairs_of_pieces`, before any of them is summed.
///
/// It is the union of the sums C of all pairs of convex pieces. A facet of one of them, in the
/// plane n · x = d, is on the boundary where no C covers what is just above it: where it lies in
/// the interior of no C and in no facet with the opposite normal. So each C takes from the facet
/// what is below all its planes, a plane that holds the facet itself counting as n says; convex
/// polygons are left, which are united plane by plane.
///
/// Exact. For k pairs of pieces, with f facets each: O(k f) facets against those of the k bodies
/// whose boxes they meet. Some 50 KiB for each pair.
PolyhedralSet definition_sum(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling);

constexpr std::size_t most_pairs_of_pieces = 65'536;

}  // namespace minkref::inline space
