// A polyhedron of any shape as convex pieces.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Splits the operand into convex polyhedra with disjoint interiors whose union is the operand,
/// which must be a valid surface without self-crossings; several components and cavities are
/// allowed. A convex operand gives one piece; a point or a segment is the only piece, the empty set
/// has none. Planes of faces cut space (a binary space partition): planes with all of the surface
/// behind them cost no piece, and each next cut leaves the least of the remaining surface. Then
/// merged_pieces.hpp joins pieces again. A piece has one face for each plane and no flat vertex.
/// Throws BadInput ("crossing-faces") if the surface has no inside, or if its volume differs from
/// the pieces' volume, and LimitExceeded ("too-many-pieces") beyond `most_convex_pieces`. Exact.
/// About O(m^2) for m faces, more where cuts split many.
std::vector<Polyhedron> convex_pieces(const Polyhedron& surface);

constexpr std::size_t most_convex_pieces = 20'000;

}  // namespace minkref::inline space
