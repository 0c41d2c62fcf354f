// An operand in space as convex pieces, the interiors of which cover what they have to.
#pragma once

#include "reference/motion/space/solid_piece.hpp"

namespace minkref::inline space {

/// Convex pieces whose union is the operand; of a plane polygon triangles. `open`: each point of
/// the interior of a solid lies in the interior of a piece, also where pieces meet; needed beside
/// an operand without volume, which may lie in the seam of two. Otherwise seams do no harm:
/// interiors that meet share a volume. Exact. As convex_pieces (definition/convex_pieces.hpp), and
/// O(k^2) for k pieces.
std::vector<SolidPiece> open_pieces(const Polyhedron& operand, bool open);

}  // namespace minkref::inline space
