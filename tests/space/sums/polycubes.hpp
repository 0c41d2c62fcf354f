// Solids of unit cells, and their sums by counted cells.
#pragma once

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "reference/error.hpp"
#include "reference/space/polyhedral_set.hpp"
#include "reference/space/polyhedron.hpp"

namespace minkref::polycubes {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;
using Matrix = std::array<std::array<int, 3>, 3>;

inline const Matrix identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline int determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// All cells of a box.
inline Cells block(Cell from, Cell to) {
  Cells cells;
  for (int x = from[0]; x < to[0]; ++x) {
    for (int y = from[1]; y < to[1]; ++y) {
      for (int z = from[2]; z < to[2]; ++z) cells.insert({x, y, z});
    }
  }
  return cells;
}

inline Cells without(Cells cells, const Cells& taken) {
  for (const Cell& cell : taken) cells.erase(cell);
  return cells;
}

inline Cells with(Cells cells, const Cells& more) {
  cells.insert(more.begin(), more.end());
  return cells;
}

/// A body's image under a matrix with positive determinant.
inline Polyhedron mapped(Polyhedron body, const Matrix& m) {
  for (SpacePoint& v : body.vertices) {
    const auto image = [&v = v, &m](std::size_t row) -> Rational {
      return m[row][0] * v.x + m[row][1] * v.y + m[row][2] * v.z;
    };
    v = {image(0), image(1), image(2)};
  }
  return body;
}

/// The union of cells under a matrix with positive determinant, with one face for each boundary
/// square.
inline Polyhedron solid(const Cells& cells, const Matrix& m = identity) {
  Polyhedron result;
  std::map<Cell, std::uint32_t> numbers;
  const auto vertex = [&](const Cell& at) {
    const auto [place, fresh] =
        numbers.try_emplace(at, static_cast<std::uint32_t>(result.vertices.size()));
    if (fresh) {
      std::array<int, 3> image{};
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) image[row] += m[row][k] * at[k];
      }
      result.vertices.push_back({image[0], image[1], image[2]});
    }
    return place->second;
  };
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (const int step : {0, 1}) {
        Cell neighbour = cell;
        neighbour[axis] += step == 1 ? 1 : -1;
        if (cells.contains(neighbour)) continue;
        std::array<Cell, 4> corners{cell, cell, cell, cell};
        for (Cell& corner : corners) corner[axis] += step;
        ++corners[1][u], ++corners[2][u], ++corners[2][v], ++corners[3][v];
        if (step == 0) std::swap(corners[1], corners[3]);
        Face& face = result.faces.emplace_back();
        for (const Cell& corner : corners) face.push_back(vertex(corner));
      }
    }
  }
  return result;
}

inline bool is_valid(const Polyhedron& body) {
  try {
    validate(body);
  } catch (const BadInput&) {
    return false;
  }
  return true;
}

/// The cells of the sum: two cells give a block of eight.
inline Cells sum_of_cells(const Cells& a, const Cells& b) {
  Cells result;
  for (const Cell& p : a) {
    for (const Cell& q : b) {
      const Cell at{p[0] + q[0], p[1] + q[1], p[2] + q[2]};
      result.merge(block(at, {at[0] + 2, at[1] + 2, at[2] + 2}));
    }
  }
  return result;
}

/// Random cells connected through faces.
inline Cells random_cells(std::mt19937& dice, std::size_t count, int size) {
  std::uniform_int_distribution<int> coordinate(0, size - 1), way(0, 5);
  Cells cells{{coordinate(dice), coordinate(dice), coordinate(dice)}};
  while (cells.size() < count) {
    auto cell =
        *std::next(cells.begin(), std::uniform_int_distribution<std::ptrdiff_t>(
                                      0, static_cast<std::ptrdiff_t>(cells.size()) - 1)(dice));
    const auto w = static_cast<std::size_t>(way(dice));
    cell[w / 2] += w % 2 == 0 ? 1 : -1;
    if (cell[w / 2] >= 0 && cell[w / 2] < size) cells.insert(cell);
  }
  return cells;
}

inline Matrix random_matrix(std::mt19937& dice, int size) {
  std::uniform_int_distribution<int> entry(-size, size);
  for (;;) {
    Matrix m;
    for (auto& row : m) {
      for (int& value : row) value = entry(dice);
    }
    if (determinant(m) > 0) return m;
  }
}

}  // namespace minkref::polycubes
