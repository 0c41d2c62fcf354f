// A polyhedron of any shape as convex pieces.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Convex polyhedra with disjoint interiors whose union is the operand, which must be a valid
/// surface that does not cross itself; several components and cavities are allowed. A convex
/// operand is one piece; a point or a segment is its own only piece, the empty set has none. Space
/// is cut by planes of faces (a binary space partition): planes with all of the surface behind them
/// cost no piece, and the next cut is the one that leaves the least of the rest of the surface.
/// Then pieces are put together again (merged_pieces.hpp). A piece has one face in each of its
/// planes and no flat vertex. Throws BadInput ("crossing-faces") where the surface has no inside,
/// or not the volume of the pieces, and LimitExceeded ("too-many-pieces") beyond
/// `most_convex_pieces`. Exact. About O(m^2) for m faces, more where cuts split many.
std::vector<Polyhedron> convex_pieces(const Polyhedron& surface);

constexpr std::size_t most_convex_pieces = 20'000;

}  // namespace minkref::inline space
