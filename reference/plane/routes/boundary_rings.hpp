// The boundary of some faces of an arrangement, whatever its coordinates.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// The boundary as closed walks, followed in the arrangement itself: they close whatever the
/// coordinates say.
template <class K, class Position>
PolygonSet boundary_rings(const Arrangement<K>& arrangement, const std::vector<bool>& inside,
                          Position&& position) {
  const auto on_boundary = [&](std::uint32_t h) {
    return inside[arrangement.face(h)] && !inside[arrangement.face(h ^ 1U)];
  };
  PolygonSet rings;
  std::vector<bool> seen(arrangement.half_edge_count(), false);
  for (std::uint32_t first = 0; first < arrangement.half_edge_count(); ++first) {
    if (seen[first] || !on_boundary(first)) continue;
    Ring ring;
    std::uint32_t h = first;
    do {
      seen[h] = true;
      ring.push_back(position(arrangement.origin(h)));
      h = arrangement.next(h);
      while (!on_boundary(h)) h = arrangement.next(h ^ 1U);
    } while (h != first);
    rings.polygons.push_back({std::move(ring), {}});
  }
  return rings;
}

}  // namespace minkref::inline plane
