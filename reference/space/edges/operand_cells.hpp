// Grid cells of one operand: in its interior, or with a point of it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "reference/space/edges/cell_grid.hpp"
#include "reference/space/edges/operand.hpp"

namespace minkref::inline space {

/// Rounds down a number no greater than an index. Quicker than a call.
inline long floor_of(double x) {
  const long towards_zero = static_cast<long>(x);
  return towards_zero - (static_cast<double>(towards_zero) > x ? 1 : 0);
}

template <class Look>
void for_cells(const CellGrid::Cell& first, const CellGrid::Cell& last, Look&& look) {
  CellGrid::Cell cell;
  for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
      for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) look(cell);
    }
  }
}

/// Whether the numbers of a box's cells are of moderate size.
bool is_usable(const SpaceBox& box, double size);

SpaceBox box_of(const SpaceOperand& body);

/// Cells of one size, a power of two. Doubles with bounds decide, and leave out uncertain cells.
class OperandCells {
 public:
  OperandCells(const SpaceOperand& body, double size);

  /// Fills both grids; returns false if the surface has too many pieces. Can be interrupted.
  bool fill();

  CellGrid inside;   ///< in the interior, with their borders
  CellGrid reached;  ///< a point of the operand is in them

 private:
  using Cell = CellGrid::Cell;

  void reach(const BoundedVector& point);
  bool reach_surface(int halvings);
  bool touch(const std::array<BoundedVector, 3>& corners, int halvings);
  void touch_box(const SpaceBox& box);
  void flood(const Cell& start);
  bool lies_inside(const Cell& cell) const;
  bool is_free(const Cell& cell) const;
  std::optional<bool> is_inside(const Cell& cell) const;

  const SpaceOperand& body_;
  double size_, inverse_size_;
  std::size_t pieces_ = 0;
  CellGrid touched_, seen_;
};

}  // namespace minkref::inline space
