// The sums of all pairs of two operands' convex pieces.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/space/definition/summand.hpp"

namespace minkref::inline space {

/// Returns A ⊕ B for all convex pieces A of S P and B of Q, except sums without volume. Throws
/// BadInput ("bad-scale"; "degenerate-operands" if neither operand is a solid; like convex_pieces),
/// and LimitExceeded ("too-many-pairs") beyond `most` pairs, before summing any pair. `with_seams`:
/// beside a point or a segment, adds the sums with the seams' covers, so that all interiors
/// together cover the sum of the interiors (seam_covers.hpp). Exact.
std::vector<SumBody> summed_pieces(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling,
                                   std::size_t most, bool with_seams = false);

}  // namespace minkref::inline space
