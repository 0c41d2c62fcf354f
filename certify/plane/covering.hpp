// A sum's cells, cut until each lies within the sum of two convex pieces.
#pragma once

#include "certify/plane/cell_complex.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::certify {

struct CoveredCell {
  Cell cell;
  std::uint32_t A = 0, B = 0;  ///< a piece of P, a piece of Q
};

class Covering {
 public:
  explicit Covering(CellComplex& complex);

  /// Cuts the cell into parts, each within the sum of two pieces, along edges of such sums:
  /// finitely many, so cutting ends. Throws std::logic_error if the cell leaves the sum.
  std::vector<CoveredCell> cover(Cell cell);

 private:
  struct Candidate {
    std::uint32_t A, B;
    std::vector<std::uint32_t> exceeded;  ///< outward normals of sA + B beyond which corners lie
  };
  std::optional<Candidate> best_for(const Cell& cell) const;
  std::uint32_t edge_of_pair(std::uint32_t A, std::uint32_t B, std::uint32_t normal);
  bool holds_inside(std::uint32_t A, std::uint32_t B, const Place& place) const;

  CellComplex& complex_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  BoxTree tree_;
};

}  // namespace minkref::certify
