// Sets of grid cells in space.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace minkref::inline space {

/// Cells with integer coordinates from `low` to `low + size - 1`; a row along the first axis is a
/// string of bits.
class CellGrid {
 public:
  using Cell = std::array<long, 3>;

  CellGrid() = default;
  CellGrid(const Cell& low, const Cell& size)
      : low_(low), size_(size), words_(static_cast<std::size_t>(size[0] + 63) / 64) {
    bits_.assign(words_ * static_cast<std::size_t>(size[1] * size[2]), 0);
  }

  const Cell& low() const { return low_; }
  const Cell& size() const { return size_; }
  bool empty() const { return bits_.empty(); }
  /// Cells outside the grid belong to no set.
  bool has(const Cell& cell) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell[k] < low_[k] || cell[k] >= low_[k] + size_[k]) return false;
    }
    const auto bit = static_cast<std::size_t>(cell[0] - low_[0]);
    return ((row(cell[1] - low_[1], cell[2] - low_[2])[bit / 64] >> (bit % 64)) & 1U) != 0;
  }
  /// Adds a grid cell.
  void add(const Cell& cell) {
    const auto bit = static_cast<std::size_t>(cell[0] - low_[0]);
    row(cell[1] - low_[1], cell[2] - low_[2])[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }

  std::size_t words() const { return words_; }
  const std::uint64_t* row(long y, long z) const { return &bits_[start(y, z)]; }
  std::uint64_t* row(long y, long z) { return &bits_[start(y, z)]; }

 private:
  std::size_t start(long y, long z) const {
    return words_ * static_cast<std::size_t>(z * size_[1] + y);
  }

  Cell low_{}, size_{};
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// Adds a + b + offset for all cells a of A and b of B; `sum` must have room for the results.
/// O(cell runs in A * rows in B * words per row), up to a logarithm.
void add_sums(CellGrid& sum, const CellGrid& A, const CellGrid& B, const CellGrid::Cell& offset);

/// The cells whose upper neighbours along each axis, and across, belong to the set as well: cubes
/// with two cells to a side.
CellGrid cubes_of_two(const CellGrid& grid);

}  // namespace minkref::inline space
