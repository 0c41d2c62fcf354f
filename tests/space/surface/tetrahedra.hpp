// Sets of grid tetrahedra, and their topology counted cell by cell.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "reference/space/polyhedral_set.hpp"

namespace minkref::surface_test {

/// Each cube of an n x n x n grid, cut into Freudenthal's six tetrahedra. Cells at the grid's rim
/// have to stay empty.
class TetrahedraGrid {
 public:
  explicit TetrahedraGrid(int n) : n_(n) {
    for (int c = 0; c < n * n * n; ++c) {
      std::array<int, 3> axes{0, 1, 2};
      do {
        std::array<int, 3> at{c % n, c / n % n, c / n / n};
        Cell cell{};
        cell[0] = vertex(at);
        for (std::size_t k = 0; k < 3; ++k) {
          ++at[static_cast<std::size_t>(axes[k])];
          cell[k + 1] = vertex(at);
        }
        if (!is_even(cells.size())) std::swap(cell[2], cell[3]);  // so that all turn one way
        cells.push_back(cell);
      } while (std::next_permutation(axes.begin(), axes.end()));
    }
    full.assign(cells.size(), false);
  }

  using Cell = std::array<int, 4>;
  std::vector<Cell> cells;
  std::vector<bool> full;

  void fill_cube(int x, int y, int z, bool value = true) {
    const int c = x + n_ * (y + n_ * z);
    for (int k = 0; k < 6; ++k) full[static_cast<std::size_t>(6 * c + k)] = value;
  }
  /// Whether the steps from corner to corner run along x, y, z, or along a rotation of this order.
  static bool is_even(std::size_t cell) { return cell % 6 == 0 || cell % 6 == 3 || cell % 6 == 4; }
  bool at_rim(std::size_t cell) const {
    const int c = static_cast<int>(cell / 6);
    for (const int k : {c % n_, c / n_ % n_, c / n_ / n_}) {
      if (k == 0 || k == n_ - 1) return true;
    }
    return false;
  }
  std::array<int, 3> place(int vertex) const {
    return {vertex % (n_ + 1), vertex / (n_ + 1) % (n_ + 1), vertex / (n_ + 1) / (n_ + 1)};
  }

  /// The corners of the side across from a corner, counter-clockwise seen from outside.
  static std::array<int, 3> side(const Cell& cell, std::size_t across) {
    static constexpr std::size_t order[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const auto& o = order[across];
    return {cell[o[0]], cell[o[1]], cell[o[2]]};
  }

  /// Exposed sides as a list of triangles, moved by a linear map.
  Polyhedron soup(const std::array<std::array<Rational, 3>, 3>& map) const {
    Polyhedron result;
    for (int v = 0; v < (n_ + 1) * (n_ + 1) * (n_ + 1); ++v) {
      std::array<Rational, 3> p;
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) p[r] += map[r][c] * place(v)[c];
      }
      result.vertices.push_back({p[0], p[1], p[2]});
    }
    std::map<std::set<int>, std::array<int, 3>> open;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (!full[c]) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto s = side(cells[c], k);
        const std::set<int> key(s.begin(), s.end());
        if (open.erase(key) == 0) open[key] = s;
      }
    }
    for (const auto& [key, s] : open) {
      result.faces.push_back({static_cast<std::uint32_t>(s[0]), static_cast<std::uint32_t>(s[1]),
                              static_cast<std::uint32_t>(s[2])});
    }
    return result;
  }

 private:
  int vertex(const std::array<int, 3>& at) const {
    return at[0] + (n_ + 1) * (at[1] + (n_ + 1) * at[2]);
  }
  int n_;
};

/// Counts for one side: for the full cells, or for the empty cells.
struct CellCount {
  std::size_t components = 0;
  std::size_t shells = 0;
  long characteristic = 0;  ///< of all shells
};

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t root(std::size_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void unite(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

inline std::size_t shared_corners(const TetrahedraGrid::Cell& a, const TetrahedraGrid::Cell& b) {
  std::size_t count = 0;
  for (const int v : a) count += static_cast<std::size_t>(std::count(b.begin(), b.end(), v));
  return count;
}

/// Faces, edges and vertices of a side's border, moved a little into that side: an edge counts once
/// for each run of the side's cells about the edge, a vertex once for each closed curve that bounds
/// the side's regions on a small sphere about the vertex: as often as the rest of the sphere has
/// parts.
inline CellCount count_cells(const TetrahedraGrid& grid, bool side) {
  const auto& cells = grid.cells;
  CellCount result;
  std::map<std::set<int>, std::vector<std::size_t>> at_face, at_edge, at_vertex;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i < 4; ++i) {
      at_vertex[{cells[c][i]}].push_back(c);
      const auto s = TetrahedraGrid::side(cells[c], i);
      at_face[std::set<int>(s.begin(), s.end())].push_back(c);
      for (std::size_t j = 0; j < i; ++j) at_edge[{cells[c][i], cells[c][j]}].push_back(c);
    }
  }
  UnionFind components(cells.size());
  std::map<std::set<int>, std::size_t> border;
  for (const auto& [corners, pair] : at_face) {
    if (pair.size() < 2) continue;
    if (grid.full[pair[0]] != grid.full[pair[1]]) {
      border.emplace(corners, border.size());
    } else {
      components.unite(pair[0], pair[1]);
    }
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    result.components += grid.full[c] == side && components.root(c) == c;
  }
  result.characteristic = static_cast<long>(border.size());
  UnionFind shells(border.size());
  /// The parts of a cell list, restricted to chosen cells and joined if cells share enough corners.
  const auto parts = [&](const std::vector<std::size_t>& about, std::size_t corners,
                         const std::function<bool(std::size_t)>& chosen) {
    std::vector<std::vector<std::size_t>> lists;
    UnionFind joined(about.size());
    for (std::size_t i = 0; i < about.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (chosen(about[i]) && chosen(about[j]) &&
            shared_corners(cells[about[i]], cells[about[j]]) >= corners) {
          joined.unite(i, j);
        }
      }
    }
    std::map<std::size_t, std::vector<std::size_t>> by_root;
    for (std::size_t i = 0; i < about.size(); ++i) {
      if (chosen(about[i])) by_root[joined.root(i)].push_back(about[i]);
    }
    for (auto& [root, list] : by_root) lists.push_back(std::move(list));
    return lists;
  };
  const auto mixed = [&](const std::vector<std::size_t>& about) {
    return std::any_of(about.begin(), about.end(),
                       [&](std::size_t c) { return grid.full[c] != grid.full[about[0]]; });
  };
  for (const auto& [ends, about] : at_edge) {
    if (!mixed(about)) continue;
    for (const auto& run : parts(about, 3, [&](std::size_t c) { return grid.full[c] == side; })) {
      --result.characteristic;
      std::vector<std::size_t> sides;
      for (const auto& [corners, number] : border) {
        if (!std::includes(corners.begin(), corners.end(), ends.begin(), ends.end())) continue;
        for (const std::size_t c : at_face[corners]) {
          if (std::count(run.begin(), run.end(), c) > 0) sides.push_back(number);
        }
      }
      if (sides.size() != 2) throw std::logic_error("a run of cells has two ends");
      shells.unite(sides[0], sides[1]);
    }
  }
  for (const auto& [corner, about] : at_vertex) {
    if (!mixed(about)) continue;
    for (const auto& run : parts(about, 3, [&](std::size_t c) { return grid.full[c] == side; })) {
      const std::set<std::size_t> inside(run.begin(), run.end());
      const auto rest = parts(about, 2, [&](std::size_t c) { return inside.count(c) == 0; });
      result.characteristic += static_cast<long>(rest.size());
    }
  }
  for (std::size_t k = 0; k < border.size(); ++k) result.shells += shells.root(k) == k;
  return result;
}

}  // namespace minkref::surface_test
