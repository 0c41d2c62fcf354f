// The sums of all pairs of convex pieces of two operands.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/space/definition/summand.hpp"

namespace minkref::inline space {

/// A ⊕ B for all convex pieces A of S P and B of Q, without those of no volume. Throws BadInput
/// ("bad-scale"; "degenerate-operands" where neither operand is a solid; as convex_pieces does),
/// and LimitExceeded ("too-many-pairs") beyond `most` pairs, before any of them is summed.
/// `with_seams`: beside a point or a segment also the sums with the seams' covers, so that the
/// interiors of all of them cover the sum of the interiors (seam_covers.hpp). Exact.
std::vector<SumBody> summed_pieces(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling,
                                   std::size_t most, bool with_seams = false);

}  // namespace minkref::inline space
