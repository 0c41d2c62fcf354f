// Cells of a grid that certainly lie in the interior of a sum (docs/space-sums.md).
#pragma once

#include <cstdint>
#include <span>

#include "reference/space/edges/cell_grid.hpp"
#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// Cubes of one size, a power of two, whose corners are multiples of it. Each of them, with its
/// border, lies in the interior of P ⊕ Q. In doubles with bounds: what is not certain is left out.
class InteriorCells {
 public:
  InteriorCells() = default;
  /// Finds cells in a grid of about `most` cells at the most. None where the numbers are beyond
  /// doubles, or the surfaces have too many pieces of the size of a cell.
  InteriorCells(const SpaceOperand& P, const SpaceOperand& Q, std::size_t most);

  /// Whether all of a point, a segment, a triangle or a parallelogram, with corners in cyclic
  /// order, is in cells. False where that is not known.
  bool contain(std::span<const BoundedVector> corners) const;

  static constexpr std::size_t most_pieces = std::size_t{1} << 22;  ///< of the surface
  static constexpr int most_halvings = 9;

 private:
  bool contain_box(const SpaceBox& box) const;
  bool contain_parts(std::span<const BoundedVector> corners, int halvings) const;

  double size_ = 1;
  CellGrid cells_;
};

}  // namespace minkref::inline space
