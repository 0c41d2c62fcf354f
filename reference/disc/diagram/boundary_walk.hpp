// The boundary of P walked outside, side by side: edges, and arcs about convex vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/diagram/edge_lookup.hpp"

namespace minkref::inline disc {

/// An edge, or a part of an edge between vertices lying on it; or the arc about a convex vertex
/// from the previous edge's normal to the next edge's.
struct BoundarySide {
  std::uint32_t feature;
  std::uint32_t edge;      ///< of an arc: that before it
  std::uint32_t next;      ///< of an arc: the edge after it
  std::uint32_t from, to;  ///< vertices, by feature
  bool is_arc;
  /// At the side's end less than half a turn is free, and the next side starts apart from this
  /// side.
  bool ends_at_reflex;
};

struct BoundaryWalk {
  std::uint32_t first, last;  ///< sides, one after the other, last excluded
  bool is_outer;              ///< around a component of P: else along a hole
};

struct BoundaryWalks {
  std::vector<BoundarySide> sides;
  std::vector<BoundaryWalk> walks;
};

/// With P on the left, and at each vertex on with the edge that comes next outside of P. Exact, in
/// rational numbers. O(n log n).
BoundaryWalks boundary_walks(const EdgeLookup& lookup);

}  // namespace minkref::inline disc
