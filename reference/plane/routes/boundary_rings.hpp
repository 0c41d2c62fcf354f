// The boundary of some faces of an arrangement, whatever its coordinates.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The boundary as closed walks from node to node, followed in the arrangement itself: they close
/// whatever the coordinates say. The faces that are `inside` lie on their left.
template <class K>
std::vector<std::vector<std::uint32_t>> boundary_nodes(const Arrangement<K>& arrangement,
                                                       const std::vector<bool>& inside) {
  const auto on_boundary = [&](std::uint32_t h) {
    return inside[arrangement.face(h)] && !inside[arrangement.face(h ^ 1U)];
  };
  std::vector<std::vector<std::uint32_t>> rings;
  std::vector<bool> seen(arrangement.half_edge_count(), false);
  for (std::uint32_t first = 0; first < arrangement.half_edge_count(); ++first) {
    if (seen[first] || !on_boundary(first)) continue;
    auto& ring = rings.emplace_back();
    std::uint32_t h = first;
    do {
      seen[h] = true;
      ring.push_back(arrangement.origin(h));
      h = arrangement.next(h);
      while (!on_boundary(h)) h = arrangement.next(h ^ 1U);
    } while (h != first);
  }
  return rings;
}

/// The same walks with the nodes' positions.
template <class K, class Position>
PolygonSet boundary_rings(const Arrangement<K>& arrangement, const std::vector<bool>& inside,
                          Position&& position) {
  PolygonSet rings;
  for (const auto& nodes : boundary_nodes(arrangement, inside)) {
    Ring ring;
    for (const std::uint32_t node : nodes) ring.push_back(position(node));
    rings.polygons.push_back({std::move(ring), {}});
  }
  return rings;
}

}  // namespace minkref::inline plane
