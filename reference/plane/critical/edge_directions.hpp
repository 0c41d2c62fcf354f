// Which convolution edges are parallel.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// For each edge the number of its direction up to sign, and whether the edge goes forward: in the
/// direction of growing x, or of growing y if the edge is upright.
struct EdgeDirections {
  std::vector<std::uint32_t> line;
  std::vector<char> forward;
  std::vector<Vector2<Rational>> along;  ///< of each number, forward

  /// The same for edges that are parallel and point the same way.
  std::uint32_t number(std::uint32_t edge) const {
    return 2 * line[edge] + static_cast<std::uint32_t>(forward[edge]);
  }
};

/// Exact. O(n log n).
EdgeDirections edge_directions(const std::vector<RationalEdge>& edges);

}  // namespace minkref::inline plane
