#include "reference/space/edges/cell_grid.hpp"

#include <algorithm>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

using Row = std::vector<std::uint64_t>;

/// target |= source << shift.
void add_shifted(std::uint64_t* target, std::size_t words, const std::uint64_t* source,
                 std::size_t source_words, std::size_t shift) {
  const std::size_t whole = shift / 64, rest = shift % 64;
  for (std::size_t k = 0; k < source_words && k + whole < words; ++k) {
    target[k + whole] |= source[k] << rest;
    if (rest != 0 && k + whole + 1 < words) target[k + whole + 1] |= source[k] >> (64 - rest);
  }
}

/// Unites a row with its copies moved by 1, ... length - 1.
void spread(Row& row, std::size_t length) {
  for (std::size_t done = 1; done < length;) {
    const std::size_t step = std::min(done, length - done);
    const Row before = row;
    add_shifted(row.data(), row.size(), before.data(), before.size(), step);
    done += step;
  }
}

struct Run {
  long from, length, y, z;
};

std::vector<Run> runs_of(const CellGrid& grid) {
  std::vector<Run> runs;
  for (long z = 0; z < grid.size()[2]; ++z) {
    for (long y = 0; y < grid.size()[1]; ++y) {
      const std::uint64_t* row = grid.row(y, z);
      for (long x = 0; x < grid.size()[0]; ++x) {
        if (((row[x / 64] >> (x % 64)) & 1U) == 0) continue;
        const bool follows = !runs.empty() && runs.back().z == z && runs.back().y == y &&
                             runs.back().from + runs.back().length == x;
        if (follows) {
          ++runs.back().length;
        } else {
          runs.push_back({x, 1, y, z});
        }
      }
    }
  }
  return runs;
}

}  // namespace

void add_sums(CellGrid& sum, const CellGrid& A, const CellGrid& B, const CellGrid::Cell& offset) {
  if (A.empty() || B.empty()) return;
  std::vector<std::pair<long, long>> rows;
  for (long z = 0; z < B.size()[2]; ++z) {
    for (long y = 0; y < B.size()[1]; ++y) {
      const std::uint64_t* row = B.row(y, z);
      if (std::any_of(row, row + B.words(), [](auto word) { return word != 0; })) {
        rows.emplace_back(y, z);
      }
    }
  }
  CellGrid::Cell move;
  for (std::size_t k = 0; k < 3; ++k) move[k] = A.low()[k] + B.low()[k] + offset[k] - sum.low()[k];
  std::vector<Run> runs = runs_of(A);
  std::stable_sort(runs.begin(), runs.end(),
                   [](const Run& a, const Run& b) { return a.length < b.length; });
  std::vector<Row> wide(rows.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    look_for_interrupt();
    const Run& run = runs[r];
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (r == 0 || runs[r - 1].length != run.length) {
        const std::uint64_t* row = B.row(rows[k].first, rows[k].second);
        wide[k].assign(B.words() + static_cast<std::size_t>(run.length) / 64 + 1, 0);
        std::copy(row, row + B.words(), wide[k].begin());
        spread(wide[k], static_cast<std::size_t>(run.length));
      }
      add_shifted(sum.row(move[1] + run.y + rows[k].first, move[2] + run.z + rows[k].second),
                  sum.words(), wide[k].data(), wide[k].size(),
                  static_cast<std::size_t>(move[0] + run.from));
    }
  }
}

CellGrid cubes_of_two(const CellGrid& grid) {
  CellGrid result(grid.low(), grid.size());
  const auto& size = grid.size();
  for (long z = 0; z + 1 < size[2]; ++z) {
    for (long y = 0; y + 1 < size[1]; ++y) {
      std::uint64_t* target = result.row(y, z);
      const std::size_t words = grid.words();
      for (std::size_t k = 0; k < words; ++k) {
        target[k] = grid.row(y, z)[k] & grid.row(y + 1, z)[k] & grid.row(y, z + 1)[k] &
                    grid.row(y + 1, z + 1)[k];
      }
      for (std::size_t k = 0; k < words; ++k) {
        const std::uint64_t next = k + 1 < words ? target[k + 1] << 63U : 0;
        target[k] &= (target[k] >> 1U) | next;
      }
    }
  }
  return result;
}

}  // namespace minkref::inline space
