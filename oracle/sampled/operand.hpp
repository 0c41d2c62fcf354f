// An operand: edges, corners, and convex pieces that tile the operand.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "oracle/sampled/number.hpp"

namespace minkref::sampled {

/// An operand breaks docs/definitions.md, or exceeds a limit.
struct BadOperand : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Rings = std::vector<std::vector<Vec<mpz_class>>>;

template <class Int>
struct Edge {
  Vec<Int> from, to;
};

/// A vertex and the directions that span the operand near the vertex: the operand lies to the left
/// of a line through the vertex iff all directions do. Vertices with a wedge beyond half a turn are
/// left out, as no such line exists there.
template <class Int>
struct Corner {
  Vec<Int> at;
  std::vector<Vec<Int>> rays;
  bool left_of(const Vec<Int>& d) const {
    return std::all_of(rays.begin(), rays.end(), [&](const auto& r) { return cross(d, r) >= 0; });
  }
};

template <class Int>
struct Operand {
  bool is_region = false, is_empty = false;
  std::vector<Edge<Int>> edges;  ///< with the operand to the left; a segment has both directions
  std::vector<Corner<Int>> corners;
  std::vector<std::vector<Vec<Int>>> pieces;  ///< counter-clockwise, or two points, or one
};

/// Whether the direction d is strictly within the counter-clockwise turn from u to w.
template <class Int>
bool within_turn(const Vec<Int>& u, const Vec<Int>& d, const Vec<Int>& w) {
  const int turn = sign(cross(u, w));
  if (turn > 0) return cross(u, d) > 0 && cross(d, w) > 0;
  if (turn < 0) return !(cross(w, d) >= 0 && cross(d, u) >= 0);
  return cross(u, d) > 0;
}

/// Makes an operand from the rings of a polygon set, outer rings counter-clockwise, holes
/// clockwise; or from two points, or one. Throws BadOperand if the rings bound no set that pieces
/// tile.
template <class Int>
Operand<Int> operand_of(const Rings& rings);

}  // namespace minkref::sampled
