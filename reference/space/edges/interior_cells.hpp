// Grid cells that certainly lie within a sum's interior (docs/space-sums.md).
#pragma once

#include <span>

#include "reference/space/edges/cell_grid.hpp"
#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// Cubes of one size, a power of two, with corners at multiples of the size. Each cube, border
/// included, lies within the interior of P ⊕ Q. Doubles with bounds decide, and leave out every
/// uncertain cube.
class InteriorCells {
 public:
  InteriorCells() = default;
  /// Finds cells within a grid of about `most` cells at the most. Finds none if numbers exceed
  /// doubles, or if the surfaces have too many cell-sized pieces.
  InteriorCells(const SpaceOperand& P, const SpaceOperand& Q, std::size_t most);

  /// Whether cells cover all of a point, a segment, a triangle or a parallelogram, with corners in
  /// cyclic order. False if unknown.
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
