// How many corners the outer Voronoi diagram of P has, told by P alone.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "reference/disc/diagram/boundary_walk.hpp"

namespace minkref::inline disc {

/// Where the diagram goes on to infinity: between two vertices that follow each other on the
/// boundary of the convex hull, counter-clockwise, and that no edge of P joins.
struct HullGap {
  std::uint32_t from, to;
};

/// Numbers with which a complete list of events agrees. The points outside of P that have two
/// nearest points or more are a graph; in each component of the complement of P this graph has as
/// many loops as there are components of P inside (docs/disc.md). So the sum of
/// (nearest points - 2) over the corners of the graph is known, and a list that reaches the sum
/// misses no corner.
struct DiagramCount {
  std::int64_t excess = 0;  ///< that sum
  /// Lines and ends of theirs, in front of which a ray ends at the graph, once each.
  std::set<std::pair<std::uint32_t, std::uint32_t>> joints;
  std::vector<HullGap> gaps;
};

/// Exact, in rational numbers. O(n log n).
DiagramCount diagram_count(const OffsetCurves& curves, const BoundaryWalks& walks);

}  // namespace minkref::inline disc
