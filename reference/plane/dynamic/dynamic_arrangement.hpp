// The arrangement of a convolution and the sum, kept while the scale changes.
#pragma once

#include "reference/plane/dynamic/boundary_states.hpp"
#include "reference/plane/dynamic/node_lists.hpp"

namespace minkref::inline plane {

/// The work of a step (Behar & Lien 2012, Sec. 4.2.4).
struct StepReport {
  std::uint64_t insertions = 0;  ///< nodes along edges; an intersection is one on each of two edges
  std::uint64_t deletions = 0;
  std::uint64_t swaps = 0;    ///< of neighbours along an edge
  std::uint64_t updated = 0;  ///< nodes that stayed and have moved
  std::uint64_t groups = 0;   ///< scales of events crossed, entered or left
};

/// Steps through a timeline in both directions: nodes are inserted, deleted and swapped along the
/// edges (node_lists.hpp), sub-edges of the boundary come and go once the boundary is asked for;
/// nothing is computed afresh.
class DynamicArrangement {
 public:
  /// At a scale just above the beginning of the window.
  explicit DynamicArrangement(std::shared_ptr<const BoundaryStates> states);

  /// Moves to a scale inside the open window; throws BadInput ("outside-window") otherwise. Exact.
  /// O(min(events crossed, nodes + edges)); for nodes `updated`, see `positions`.
  StepReport move_to(const Rational& scale);

  const Rational& scale() const { return scale_; }
  /// Whether the scale belongs to a group of events.
  bool at_event() const { return lists_.place() % 2 == 1; }
  /// The group at or just above the scale.
  std::uint32_t group() const { return lists_.place() / 2; }

  /// Nodes along an edge, ordered as at this scale, without the edge's own ends; at a group's scale
  /// neighbours may coincide.
  std::span<const std::uint32_t> nodes(std::uint32_t edge) const { return lists_.along(edge); }
  std::size_t node_count() const { return lists_.size(); }
  /// Exact.
  Point position(std::uint32_t edge, std::uint32_t node) const;
  /// The winding numbers beside the gaps of an edge: from its start to its first node, and after
  /// each node. A gap of no length has none; its entry means nothing. Only for the full
  /// convolution. Exact. O(nodes of the edge).
  std::vector<SideNumbers> winding_numbers(std::uint32_t edge) const;
  /// The positions of all nodes as doubles, edge by edge: x, y, x, y, ... O(nodes).
  void positions(std::vector<double>& xy) const;

  /// The sum's boundary at this scale, from its sub-edges. Exact. O(b log b) for b sub-edges, and
  /// O(boundary events crossed since the last call).
  BoundaryGraph boundary();

 private:
  /// As doubles: an edge's p, q and d (see MovingEdge); a node's motion along its edge.
  struct Line {
    double px, py, qx, qy, dx, dy;
  };
  struct Motion {
    double slope, value;
  };
  void place_nodes_in_doubles();
  void move_boundary(std::uint32_t interval);
  void pass_parallel_edges(std::uint32_t edge, std::vector<SideNumbers>& numbers) const;

  std::shared_ptr<const BoundaryStates> states_;
  const ArrangementTimeline& timeline_;
  CycleFinder cycles_;
  NodeLists lists_;
  std::vector<Line> lines_;
  std::vector<Motion> motions_;  ///< of each node of the table
  std::uint32_t interval_ = 0;   ///< whose sub-edges are kept
  std::vector<std::uint32_t> sub_edges_, where_;
  Rational scale_;
};

}  // namespace minkref::inline plane
