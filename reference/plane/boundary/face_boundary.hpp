// The boundary of a union of an arrangement's faces.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"

namespace minkref::inline plane {

/// Sub-edges between a face inside and a face outside, the inside on their left. `position(n)`
/// gives a node's exact coordinates; it is asked once for each node on the boundary. `take(h)`
/// hears each half-edge that becomes an edge of the graph, in the graph's order.
template <class K, class Position, class Take>
BoundaryGraph face_boundary(const Arrangement<K>& arrangement, const std::vector<bool>& inside,
                            Position&& position, Take&& take) {
  BoundaryGraph graph;
  std::vector<std::uint32_t> number(arrangement.node_count(), Arrangement<K>::none);
  const auto point = [&](std::uint32_t n) {
    if (number[n] == Arrangement<K>::none) {
      number[n] = static_cast<std::uint32_t>(graph.points.size());
      graph.points.push_back(position(n));
    }
    return number[n];
  };
  for (std::uint32_t h = 0; h < arrangement.half_edge_count(); ++h) {
    look_for_interrupt();
    if (inside[arrangement.face(h)] && !inside[arrangement.face(h ^ 1U)]) {
      const std::uint32_t from = point(arrangement.origin(h));
      graph.edges.emplace_back(from, point(arrangement.target(h)));
      take(h);
    }
  }
  return graph;
}

template <class K, class Position>
BoundaryGraph face_boundary(const Arrangement<K>& arrangement, const std::vector<bool>& inside,
                            Position&& position) {
  return face_boundary(arrangement, inside, std::forward<Position>(position), [](std::uint32_t) {});
}

}  // namespace minkref::inline plane
