// Convex operands in the plane: their vertices and edges.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// A strictly convex polygon, counter-clockwise from its lexicographically least vertex. Edge i
/// runs from vertex i to the next one.
struct ConvexRing {
  std::vector<Point> vertices;
  std::vector<Point> directions;  ///< of the edges; exact

  std::size_t size() const { return vertices.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
};

/// The operand's ring without straight vertices. Throws BadInput ("not-convex"), with the name,
/// unless the set is one convex polygon without holes and with an area. Exact, O(n).
ConvexRing convex_ring(const PolygonSet& set, const std::string& name);

/// Whether convex_ring takes the set.
bool is_convex(const PolygonSet& set);

}  // namespace minkref::inline plane
