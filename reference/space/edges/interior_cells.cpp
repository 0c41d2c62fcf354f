#include "reference/space/edges/interior_cells.hpp"

#include <algorithm>
#include <cmath>

#include "reference/space/edges/halved.hpp"
#include "reference/space/edges/operand_cells.hpp"

namespace minkref::inline space {
namespace {

using Cell = CellGrid::Cell;

CellGrid room_for_sums(const CellGrid& a, const CellGrid& b) {
  Cell low, size;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = a.low()[k] + b.low()[k];
    size[k] = a.size()[k] + b.size()[k] + 1;
  }
  return {low, size};
}

/// A cube two cells wide, moved by any point of a cell, covers its middle cell.
void add_moved(CellGrid& sum, const CellGrid& moved, const CellGrid& inside) {
  add_sums(sum, moved, cubes_of_two(inside), {1, 1, 1});
}

}  // namespace

InteriorCells::InteriorCells(const SpaceOperand& P, const SpaceOperand& Q, std::size_t most) {
  const SpaceBox of_P = box_of(P), of_Q = box_of(Q);
  std::array<double, 3> extent;
  double widest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    extent[k] = of_P.high[k] - of_P.low[k] + of_Q.high[k] - of_Q.low[k];
    widest = std::max(widest, extent[k]);
  }
  if (!(widest > 1e-200 && widest < 1e200)) return;
  int exponent = 0;
  std::frexp(widest, &exponent);
  const auto count = [&](double size) {
    return (extent[0] / size + 8) * (extent[1] / size + 8) * (extent[2] / size + 8);
  };
  size_ = std::ldexp(1, exponent);
  while (count(size_ / 2) <= static_cast<double>(most)) size_ /= 2;
  if (!is_usable(of_P, size_) || !is_usable(of_Q, size_)) return;
  OperandCells first(P, size_), second(Q, size_);
  if (!first.fill() || !second.fill()) return;
  cells_ = room_for_sums(first.inside, second.inside);
  add_moved(cells_, first.reached, second.inside);
  add_moved(cells_, second.reached, first.inside);
}

bool InteriorCells::contain_box(const SpaceBox& box) const {
  if (!is_usable(box, size_)) return false;
  const double inverse_size = 1 / size_;
  Cell first, last;
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = floor_of(box.low[k] * inverse_size);
    last[k] = floor_of(box.high[k] * inverse_size);
    if (last[k] - first[k] > 2) return false;
  }
  bool all = true;
  for_cells(first, last, [&](const Cell& cell) { all = all && cells_.has(cell); });
  return all;
}

bool InteriorCells::contain(std::span<const BoundedVector> corners) const {
  if (cells_.empty()) return false;
  for (const BoundedVector& corner : corners) {
    if (!contain_box(box_around(corner))) return false;
  }
  return corners.size() == 1 || contain_parts(corners, most_halvings);
}

bool InteriorCells::contain_parts(std::span<const BoundedVector> corners, int halvings) const {
  if (contain_box(minkref::space::box_of(corners))) return true;
  if (halvings == 0) return false;
  return all_halves(corners, [&](auto part) { return contain_parts(part, halvings - 1); });
}

}  // namespace minkref::inline space
