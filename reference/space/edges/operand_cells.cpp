#include "reference/space/edges/operand_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/space/edges/halved.hpp"
#include "reference/space/edges/interior_cells.hpp"

namespace minkref::inline space {
namespace {

using Cell = CellGrid::Cell;

constexpr double most_index = 1e9;

/// The cells that a closed box meets, border included, from the first to the second. The size is a
/// power of two: quotients become products, and exact.
std::pair<Cell, Cell> cells_about(const SpaceBox& box, double inverse_size) {
  std::pair<Cell, Cell> cells;
  for (std::size_t k = 0; k < 3; ++k) {
    cells.first[k] = -floor_of(-box.low[k] * inverse_size) - 1;
    cells.second[k] = floor_of(box.high[k] * inverse_size);
  }
  return cells;
}

/// About the longest; any will do.
std::size_t longest_side(const std::array<BoundedVector, 3>& corners) {
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double way = corners[(k + 1) % 3][i].value - corners[k][i].value;
      square += way * way;
    }
    if (square > most) {
      most = square;
      longest = k;
    }
  }
  return longest;
}

}  // namespace

bool is_usable(const SpaceBox& box, double size) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(std::abs(box.low[k]) / size < most_index && std::abs(box.high[k]) / size < most_index)) {
      return false;
    }
  }
  return true;
}

SpaceBox box_of(const SpaceOperand& body) {
  SpaceBox box;
  for (const FilteredVector& point : body.points) box.add(box_around(point.rounded));
  return box;
}

OperandCells::OperandCells(const SpaceOperand& body, double size)
    : body_(body), size_(size), inverse_size_(1 / size) {
  const auto [first, last] = cells_about(box_of(body), inverse_size_);
  Cell low, extent;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = first[k] - 1;
    extent[k] = last[k] - first[k] + 3;
  }
  touched_ = seen_ = inside = reached = CellGrid(low, extent);
}

bool OperandCells::fill() {
  if (!reach_surface(2 * InteriorCells::most_halvings)) return false;
  const Cell &low = touched_.low(), &size = touched_.size();
  for_cells(low, {low[0] + size[0] - 1, low[1] + size[1] - 1, low[2] + size[2] - 1},
            [&](const Cell& cell) {
              if (!touched_.has(cell) && !seen_.has(cell)) flood(cell);
            });
  return true;
}

bool OperandCells::reach_surface(int halvings) {
  for (const FilteredVector& point : body_.points) reach(point.rounded);
  for (const SpaceOperand::Triangle& triangle : body_.triangles) {
    look_for_interrupt();
    const std::array corners{body_.points[triangle.corners[0]].rounded,
                             body_.points[triangle.corners[1]].rounded,
                             body_.points[triangle.corners[2]].rounded};
    if (!touch(corners, halvings)) return false;
  }
  return true;
}

void OperandCells::reach(const BoundedVector& point) {
  const SpaceBox box = box_around(point);
  Cell cell;
  for (std::size_t k = 0; k < 3; ++k) {
    cell[k] = floor_of(box.low[k] * inverse_size_);
    if (static_cast<double>(cell[k] + 1) * size_ < box.high[k]) return;
  }
  reached.add(cell);
}

/// Marks a triangle's cells, halving the triangle across the longest side down to cell size.
bool OperandCells::touch(const std::array<BoundedVector, 3>& corners, int halvings) {
  look_for_interrupt();
  const SpaceBox box = box_of(corners);
  if (++pieces_ > InteriorCells::most_pieces) return false;
  const bool is_small = box.high[0] - box.low[0] <= size_ && box.high[1] - box.low[1] <= size_ &&
                        box.high[2] - box.low[2] <= size_;
  if (!is_small && halvings > 0) {
    const std::size_t k = longest_side(corners);
    const BoundedVector &a = corners[k], &b = corners[(k + 1) % 3], &c = corners[(k + 2) % 3];
    const BoundedVector half = middle(a, b);
    return touch({a, half, c}, halvings - 1) && touch({half, b, c}, halvings - 1);
  }
  for (const BoundedVector& corner : corners) reach(corner);
  touch_box(box);
  return true;
}

void OperandCells::touch_box(const SpaceBox& box) {
  const auto [first, last] = cells_about(box, inverse_size_);
  for_cells(first, last, [&](const Cell& cell) { touched_.add(cell); });
}

/// Untouched cells connected by faces lie all inside or all outside.
void OperandCells::flood(const Cell& start) {
  const bool is_in = lies_inside(start);
  std::vector<Cell> left{start};
  seen_.add(start);
  while (!left.empty()) {
    look_for_interrupt();
    const Cell cell = left.back();
    left.pop_back();
    if (is_in) {
      inside.add(cell);
      reached.add(cell);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (const long step : {-1, 1}) {
        Cell next = cell;
        next[k] += step;
        const long at = next[k] - seen_.low()[k];
        if (at < 0 || at >= seen_.size()[k] || touched_.has(next) || seen_.has(next)) continue;
        seen_.add(next);
        left.push_back(next);
      }
    }
  }
}

/// Whether an untouched cell lies inside, by cells connected with it where its middle does not
/// tell, as below an edge; false if none tells.
bool OperandCells::lies_inside(const Cell& cell) const {
  constexpr long steps = 3;
  Cell at = cell;
  for (at[0] = cell[0]; at[0] < cell[0] + steps && is_free(at); ++at[0]) {
    for (at[1] = cell[1]; at[1] < cell[1] + steps && is_free(at); ++at[1]) {
      for (at[2] = cell[2]; at[2] < cell[2] + steps && is_free(at); ++at[2]) {
        if (const auto told = is_inside(at)) return *told;
      }
      at[2] = cell[2];
    }
    at[1] = cell[1];
  }
  return false;
}

bool OperandCells::is_free(const Cell& cell) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const long place = cell[k] - touched_.low()[k];
    if (place < 0 || place >= touched_.size()[k]) return false;
  }
  return !touched_.has(cell);
}

/// Whether a cell's middle lies inside, by the triangles above along the third axis; nothing if
/// doubles do not tell.
std::optional<bool> OperandCells::is_inside(const Cell& cell) const {
  BoundedVector x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = real((static_cast<double>(cell[k]) + 0.5) * size_);
  int winding = 0;
  for (const SpaceOperand::Triangle& triangle : body_.triangles) {
    const int facing = triangle.normal.exact[2].sign();
    if (facing == 0) continue;
    int over = 1;
    for (std::size_t k = 0; over > 0 && k < 3; ++k) {
      const BoundedVector& from = body_.points[triangle.corners[k]].rounded;
      const BoundedVector along = body_.points[triangle.corners[(k + 1) % 3]].rounded - from;
      const BoundedVector off = x - from;
      const int turn = (along[0] * off[1] - along[1] * off[0]).certain_sign();
      if (turn == 0 || turn == BoundedDouble::undecided) return std::nullopt;
      over = turn * facing;
    }
    if (over < 0) continue;
    const BoundedVector off = x - body_.points[triangle.corners[0]].rounded;
    const int height = dot(triangle.normal.rounded, off).certain_sign();
    if (height == 0 || height == BoundedDouble::undecided) return std::nullopt;
    if (height == -facing) winding += facing;
  }
  return winding > 0;
}

}  // namespace minkref::inline space
