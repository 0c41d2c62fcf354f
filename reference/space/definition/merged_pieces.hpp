// Merges convex pieces that together form one convex piece.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// The same solid as fewer pieces: joins pairs with a convex union, that is, with opposite faces in
/// one plane and each piece below the other piece's remaining planes. For the common plane cuts the
/// part below these other planes into the two pieces. The pieces must be convex with disjoint
/// interiors, and have one face for each plane; so do the results. Greedy. Exact.
std::vector<Polyhedron> merged_pieces(const std::vector<Polyhedron>& pieces);

}  // namespace minkref::inline space
