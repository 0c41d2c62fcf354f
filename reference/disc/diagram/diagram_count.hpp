// How many corners the outer Voronoi diagram of P has, told by P alone.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "reference/disc/diagram/boundary_walk.hpp"

namespace minkref::inline disc {

/// A gap through which the diagram goes on to infinity: between two consecutive vertices on the
/// convex hull's boundary, counter-clockwise, that no edge of P joins.
struct HullGap {
  std::uint32_t from, to;
};

/// Numbers that a complete list of events must match. The points outside P with two or more nearest
/// points form a graph; in each component of the complement of P this graph has as many loops as
/// there are components of P inside (docs/disc.md). So the sum of (nearest points - 2) over the
/// graph's corners is known, and a list that reaches the sum misses no corner.
struct DiagramCount {
  std::int64_t excess = 0;  ///< that sum
  /// Pairs of a line and an end, once each, where a ray in front of the end stops at the graph.
  std::set<std::pair<std::uint32_t, std::uint32_t>> joints;
  std::vector<HullGap> gaps;
};

/// Exact, in rational numbers. O(n log n).
DiagramCount diagram_count(const OffsetCurves& curves, const BoundaryWalks& walks);

}  // namespace minkref::inline disc
