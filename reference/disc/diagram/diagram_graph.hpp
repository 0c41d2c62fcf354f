// The outer Voronoi diagram of P as a graph: the events that each part joins. Exact.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/diagram/diagram_events.hpp"

namespace minkref::inline disc {

/// One side of a part of the diagram, between two consecutive nodes along the boundary of P, walked
/// with P on the left. Along the side the radius only grows, or only shrinks, or stays.
struct DiagramHalf {
  std::uint32_t from, to;  ///< nodes
  std::uint32_t twin;      ///< the other side, from `to` to `from`
  std::uint32_t feature;   ///< that it is in front of; of the twin, the one across
  /// The boundary sides in front of the half's ends.
  std::uint32_t from_side, to_side;
};

/// Nodes: the events, by number; then the gaps of the hull, at infinity; then the reflex vertices.
struct DiagramGraph {
  std::size_t events, gaps, reflex_vertices;
  std::vector<DiagramHalf> halves;  ///< in order along the walks
  struct Walk {
    std::uint32_t first, last;  ///< halves, last excluded
  };
  std::vector<Walk> walks;  ///< as those of the boundary
  /// Where the boundary looks to the left at a polygon's leftmost vertex: the half there, or the
  /// last half before; none if the walk has no halves, or if P does not end there.
  struct Leftmost {
    std::uint32_t vertex, walk, half;
  };
  static constexpr std::uint32_t none = UINT32_MAX;
  std::vector<Leftmost> leftmost;  ///< by polygon

  bool is_event(std::uint32_t node) const { return node < events; }
  bool is_infinite(std::uint32_t node) const { return node >= events && node < events + gaps; }
  bool is_reflex(std::uint32_t node) const { return node >= events + gaps; }
};

/// Builds the graph from complete events (diagram_events). Sorts an event's nearest points by
/// direction, and the events nearest to a part of the boundary of P along this part. Finds each
/// part of the diagram from both sides, or throws std::logic_error, which would be a fault. O(n log
/// n).
DiagramGraph diagram_graph(const DiagramEvents& diagram);

}  // namespace minkref::inline disc
