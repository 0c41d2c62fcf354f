// The history of the convolution edges as the scale grows: nodes come, go and swap; sub-edges are
// on the boundary of the sum for a while.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/dynamic/winding_history.hpp"
#include "reference/plane/history/boundary_cycles.hpp"

namespace minkref::inline plane {

/// An edge's own ends, wherever a node is expected.
inline constexpr std::uint32_t start_of_edge = 0xfffffffeU, end_of_edge = 0xfffffffdU;

/// A change of the node order along an edge. Each group g of events has two steps: after step 2 g
/// the arrangement stands at the group's scale, after 2 g + 1 just above.
struct NodeChange {
  enum class Kind : std::uint8_t {
    insertion,  ///< of `node`, at `rank` among the edge's nodes
    deletion,   ///< of `node`, from `rank`
    swap,       ///< of `node`, at `rank`, with the next one; both are there below and above
    settling    ///< a swap of coincident nodes, one of them a new arrival of this group
  };
  std::uint32_t step = 0;
  std::uint32_t edge = 0, node = 0, rank = 0;
  Kind kind = Kind::insertion;
};

/// A NodeChange within a list sorted by step; its node tells the edge. Millions of them exist.
struct PackedChange {
  std::uint32_t node;
  std::uint32_t rank_and_kind;

  explicit PackedChange(const NodeChange& change)
      : node(change.node),
        rank_and_kind(change.rank << 2 | static_cast<std::uint32_t>(change.kind)) {}
  std::uint32_t rank() const { return rank_and_kind >> 2; }
  NodeChange::Kind kind() const { return static_cast<NodeChange::Kind>(rank_and_kind & 3); }
};

/// A piece of an edge between two of its nodes that belongs to the sum's boundary during the open
/// scale intervals `first` to `last`; interval i lies between groups i - 1 and i.
struct SubEdge {
  std::uint32_t edge = 0;
  std::uint32_t from = 0, to = 0;  ///< nodes, or start_of_edge, end_of_edge
  std::uint32_t first = 0, last = 0;
};

/// A piece of an edge on the boundary at a group's scale, unless a sub-edge simply goes on: part of
/// `before`, later part of `after` (either may be no_sub_edge).
struct SubEdgeAtGroup {
  std::uint32_t group = 0, edge = 0;
  std::uint32_t from = 0, to = 0;
  std::uint32_t before = no_sub_edge, after = no_sub_edge;
};

/// An edge's nodes coinciding at a group's scale.
struct CoincidentNodes {
  std::uint32_t group = 0, edge = 0;
  std::vector<std::uint32_t> nodes;
};

/// The history of all swept edges; each list has the edges' order.
struct EdgeHistory {
  std::vector<std::vector<std::uint32_t>> initial;  ///< nodes along each edge in interval 0
  std::vector<NodeChange> changes;
  std::vector<SubEdge> sub_edges;
  std::vector<SubEdgeAtGroup> at_groups;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> interrupted;  ///< group, sub-edge that goes
                                                                     ///< on, in pieces at the group
  std::vector<CoincidentNodes> coincident;
  WindingHistory winding;                                     ///< of the full convolution only
  std::uint64_t decided_by_doubles = 0, decided_exactly = 0;  ///< collision detection
};

}  // namespace minkref::inline plane
