// Convex pieces that are one convex piece together.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// The same solid in fewer pieces, where pairs of them have a convex union: where they have
/// opposite faces in one plane, and each lies below all other planes of the other. For then what is
/// below these planes is cut by that one into the two. The pieces are convex with disjoint
/// interiors, and have one face in each plane; so have those that are given back. Greedy. Exact.
std::vector<Polyhedron> merged_pieces(const std::vector<Polyhedron>& pieces);

}  // namespace minkref::inline space
