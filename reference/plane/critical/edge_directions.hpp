// Finds parallel convolution edges.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// Each edge's number for its direction up to sign, and whether the edge goes forward: towards
/// growing x, or growing y if upright.
struct EdgeDirections {
  std::vector<std::uint32_t> line;
  std::vector<char> forward;
  std::vector<Vector2<Rational>> along;  ///< of each number, forward

  /// A number shared by parallel edges with the same direction.
  std::uint32_t number(std::uint32_t edge) const {
    return 2 * line[edge] + static_cast<std::uint32_t>(forward[edge]);
  }
};

/// Exact. O(n log n).
EdgeDirections edge_directions(const std::vector<RationalEdge>& edges);

}  // namespace minkref::inline plane
