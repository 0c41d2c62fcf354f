// The history of the convolution edges as the scale grows: nodes come, go and swap; sub-edges are
// on the boundary of the sum for a while.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/history/boundary_cycles.hpp"

namespace minkref::inline plane {

/// Ends of an edge where a node is asked for.
inline constexpr std::uint32_t start_of_edge = 0xfffffffeU, end_of_edge = 0xfffffffdU;

/// A change of the order of nodes along an edge. Each group of events has two steps: 2 g, after
/// which the arrangement is that at the scale of group g, and 2 g + 1, after which it is that just
/// above.
struct NodeChange {
  enum class Kind : std::uint8_t {
    insertion,  ///< of `node`, at `rank` among the edge's nodes
    deletion,   ///< of `node`, from `rank`
    swap,       ///< of `node`, at `rank`, with the next one; both are there below and above
    settling    ///< a swap of nodes in one place, one of which has arrived in this group
  };
  std::uint32_t step = 0;
  std::uint32_t edge = 0, node = 0, rank = 0;
  Kind kind = Kind::insertion;
};

/// A NodeChange in a list that is sorted by step; the edge is that of the node. There are millions.
struct PackedChange {
  std::uint32_t node;
  std::uint32_t rank_and_kind;

  explicit PackedChange(const NodeChange& change)
      : node(change.node),
        rank_and_kind(change.rank << 2 | static_cast<std::uint32_t>(change.kind)) {}
  std::uint32_t rank() const { return rank_and_kind >> 2; }
  NodeChange::Kind kind() const { return static_cast<NodeChange::Kind>(rank_and_kind & 3); }
};

/// A piece of an edge between two of its nodes that is on the boundary of the sum in the open
/// intervals of scales `first` to `last`; interval i lies between groups i - 1 and i.
struct SubEdge {
  std::uint32_t edge = 0;
  std::uint32_t from = 0, to = 0;  ///< nodes, or start_of_edge, end_of_edge
  std::uint32_t first = 0, last = 0;
};

/// A piece of an edge on the boundary at the scale of a group, where it is not simply a sub-edge
/// that goes on: it is part of `before` and becomes part of `after` (either may be no_sub_edge).
struct SubEdgeAtGroup {
  std::uint32_t group = 0, edge = 0;
  std::uint32_t from = 0, to = 0;
  std::uint32_t before = no_sub_edge, after = no_sub_edge;
};

/// Nodes of an edge that are one point at the scale of a group.
struct CoincidentNodes {
  std::uint32_t group = 0, edge = 0;
  std::vector<std::uint32_t> nodes;
};

/// The history of all edges that have been swept; each list in the order of the edges.
struct EdgeHistory {
  std::vector<std::vector<std::uint32_t>> initial;  ///< nodes along each edge in interval 0
  std::vector<NodeChange> changes;
  std::vector<SubEdge> sub_edges;
  std::vector<SubEdgeAtGroup> at_groups;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> interrupted;  ///< group, sub-edge that goes
                                                                     ///< on, in pieces at the group
  std::vector<CoincidentNodes> coincident;
  std::uint64_t decided_by_doubles = 0, decided_exactly = 0;  ///< collision detection
};

}  // namespace minkref::inline plane
