#include "reference/space/edges/interior_cells.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/space/edges/halved.hpp"

namespace minkref::inline space {
namespace {

using Cell = CellGrid::Cell;

constexpr double most_index = 1e9;

/// Rounds down a number no greater than an index. Quicker than a call.
long floor_of(double x) {
  const long towards_zero = static_cast<long>(x);
  return towards_zero - (static_cast<double>(towards_zero) > x ? 1 : 0);
}

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

bool is_usable(const SpaceBox& box, double size) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(std::abs(box.low[k]) / size < most_index && std::abs(box.high[k]) / size < most_index)) {
      return false;
    }
  }
  return true;
}

template <class Look>
void for_cells(const Cell& first, const Cell& last, Look&& look) {
  Cell cell;
  for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) {
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1]) {
      for (cell[0] = first[0]; cell[0] <= last[0]; ++cell[0]) look(cell);
    }
  }
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

/// An operand's cells.
class OperandCells {
 public:
  OperandCells(const SpaceOperand& body, double size)
      : body_(body), size_(size), inverse_size_(1 / size) {
    SpaceBox box;
    for (const FilteredVector& point : body.points) box.add(box_around(point.rounded));
    const auto [first, last] = cells_about(box, inverse_size_);
    Cell low, extent;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = first[k] - 1;
      extent[k] = last[k] - first[k] + 3;
    }
    touched_ = seen_ = inside = reached = CellGrid(low, extent);
  }

  /// Fills the grids; returns false if the surface has too many pieces.
  bool fill() {
    for (const FilteredVector& point : body_.points) reach(point.rounded);
    for (const SpaceOperand::Triangle& triangle : body_.triangles) {
      look_for_interrupt();
      const std::array corners{body_.points[triangle.corners[0]].rounded,
                               body_.points[triangle.corners[1]].rounded,
                               body_.points[triangle.corners[2]].rounded};
      if (!touch(corners, 2 * InteriorCells::most_halvings)) return false;
    }
    const Cell &low = touched_.low(), &size = touched_.size();
    for_cells(low, {low[0] + size[0] - 1, low[1] + size[1] - 1, low[2] + size[2] - 1},
              [&](const Cell& cell) {
                if (!touched_.has(cell) && !seen_.has(cell)) flood(cell);
              });
    return true;
  }

  CellGrid inside;   ///< in the interior, with their borders
  CellGrid reached;  ///< a point of the operand is in them

 private:
  void reach(const BoundedVector& point) {
    Cell cell;
    const SpaceBox box = box_around(point);
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = floor_of(box.low[k] * inverse_size_);
      if (static_cast<double>(cell[k] + 1) * size_ < box.high[k]) return;
    }
    reached.add(cell);
  }

  /// Marks a triangle's cells, halving the triangle across the longest side down to cell size.
  bool touch(const std::array<BoundedVector, 3>& corners, int halvings) {
    look_for_interrupt();
    if (++pieces_ > InteriorCells::most_pieces) return false;
    const SpaceBox box = box_of(corners);
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

  void touch_box(const SpaceBox& box) {
    const auto [first, last] = cells_about(box, inverse_size_);
    for_cells(first, last, [&](const Cell& cell) { touched_.add(cell); });
  }

  /// Untouched cells connected by faces lie all inside or all outside.
  void flood(const Cell& start) {
    const bool is_in = is_inside(start);
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

  /// Whether a cell's middle lies inside, by the triangles above along the third axis; false also
  /// if doubles do not tell.
  bool is_inside(const Cell& cell) const {
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
        if (turn == 0 || turn == BoundedDouble::undecided) return false;
        over = turn * facing;
      }
      if (over < 0) continue;
      const BoundedVector off = x - body_.points[triangle.corners[0]].rounded;
      const int height = dot(triangle.normal.rounded, off).certain_sign();
      if (height == 0 || height == BoundedDouble::undecided) return false;
      if (height == -facing) winding += facing;
    }
    return winding > 0;
  }

  const SpaceOperand& body_;
  double size_, inverse_size_;
  std::size_t pieces_ = 0;
  CellGrid touched_, seen_;
};

SpaceBox box_of(const SpaceOperand& body) {
  SpaceBox box;
  for (const FilteredVector& point : body.points) box.add(box_around(point.rounded));
  return box;
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
  Cell low, size;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = first.inside.low()[k] + second.inside.low()[k];
    size[k] = first.inside.size()[k] + second.inside.size()[k] + 1;
  }
  cells_ = CellGrid(low, size);
  // A cube two cells wide, moved by any point of a cell, covers its middle cell.
  const auto add = [&](const CellGrid& moved, const CellGrid& inside) {
    add_sums(cells_, moved, cubes_of_two(inside), {1, 1, 1});
  };
  add(first.reached, second.inside);
  add(second.reached, first.inside);
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
