// Both operands within a common frame of a kernel's coordinates: the scaled P and Q, ring by ring.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// An operand's rings: outer, holes, outer, holes, ...
template <class V>
struct Operand {
  std::vector<std::vector<V>> rings;
  std::vector<bool> is_outer;

  std::size_t vertices() const {
    std::size_t count = 0;
    for (const auto& ring : rings) count += ring.size();
    return count;
  }
};

/// Converts each vertex by `convert(Point) -> V`.
template <class V, class Convert>
Operand<V> operand(const PolygonSet& set, Convert&& convert) {
  Operand<V> result;
  const auto add = [&](const Ring& ring, bool outer) {
    auto& vertices = result.rings.emplace_back();
    vertices.reserve(ring.size());
    for (const Point& point : ring) vertices.push_back(convert(point));
    result.is_outer.push_back(outer);
  };
  for (const Polygon& polygon : set.polygons) {
    add(polygon.outer, true);
    for (const Ring& hole : polygon.holes) add(hole, false);
  }
  return result;
}

}  // namespace minkref::inline plane
