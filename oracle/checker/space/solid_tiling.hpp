// Both operands of a certificate as convex pieces. docs/certificates-solids.md, "Pieces"
#pragma once

#include <array>
#include <vector>

#include "oracle/checker/space/solid_pieces.hpp"
#include "oracle/checker/space/space.hpp"

namespace minkref::checker {

/// Pieces that tile P and Q, in units that make all coordinates whole.
struct Tiling {
  mpz_class unit;
  std::array<PieceList, 2> lists;
  std::array<std::vector<Hull>, 2> pieces;
};

/// Reads the pieces of P and Q, and checks that they tile the operands. Throws NotVerified.
Tiling checked_tiling(std::array<Body, 2>& bodies, const Value& pieces_of_P,
                      const Value& pieces_of_Q, Budget& budget);

}  // namespace minkref::checker
