// An operand in space as convex pieces whose interiors cover the interior as far as needed.
#pragma once

#include "reference/motion/space/solid_piece.hpp"

namespace minkref::inline space {

/// Convex pieces whose union is the operand; triangles for a plane polygon. `open`: each interior
/// point of a solid lies inside some piece, also where pieces meet; needed beside an operand
/// without volume, which may lie along the seam of two. Otherwise seams do no harm: interiors that
/// meet share a volume. Exact. As convex_pieces (definition/convex_pieces.hpp), and O(k^2) for k
/// pieces.
std::vector<SolidPiece> open_pieces(const Polyhedron& operand, bool open);

}  // namespace minkref::inline space
