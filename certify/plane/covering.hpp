// Cells of a sum, cut until each lies in the sum of two convex pieces.
#pragma once

#include "certify/plane/cell_complex.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::certify {

struct CoveredCell {
  Cell cell;
  std::uint32_t A = 0, B = 0;  ///< pieces of P and of Q
};

class Covering {
 public:
  explicit Covering(CellComplex& complex);

  /// The cell in parts, each within the sum of two pieces. Cuts are along edges of such sums: there
  /// are finitely many, so it ends. Throws std::logic_error if the cell is not in the sum.
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
