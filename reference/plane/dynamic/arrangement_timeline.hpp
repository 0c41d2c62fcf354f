// A convolution's arrangement: its whole history over a window of scales.
#pragma once

#include <array>
#include <memory>

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/dynamic/edge_history.hpp"
#include "reference/plane/dynamic/node_track.hpp"

namespace minkref::inline plane {

/// The array of critical events of Behar & Lien 2012, Sec. 4.2.4, with each event's effect on the
/// nodes along the edges; includes triple events, which the paper lacks. Interval i of scales lies
/// between groups i - 1 and i.
struct ArrangementTimeline {
  std::shared_ptr<const ArrangementEvents> events;
  std::vector<std::vector<std::uint32_t>> initial;  ///< nodes along each edge in interval 0
  std::vector<PackedChange> changes;                ///< sorted by step
  std::vector<std::size_t> first_change;            ///< of each step, and the end
  std::vector<std::uint32_t> edge_of_node;
  std::vector<SubEdge> sub_edges;
  std::vector<SubEdgeAtGroup> at_groups;                             ///< sorted by group
  std::vector<std::pair<std::uint32_t, std::uint32_t>> interrupted;  ///< sorted by group
  std::vector<CoincidentNodes> coincident;                           ///< sorted by group
  WindingHistory winding;  ///< of the full convolution only
  std::uint64_t decided_by_doubles = 0, decided_exactly = 0;

  Track track(std::uint32_t edge, std::uint32_t node) const {
    return node_track(*events, edge, node);
  }
};

/// Over an open window. Exact. O(N^2 + sum of k^2) for N edges with k nodes each; memory O(N +
/// events). Operands must have passed `validate` and be neither empty nor both degenerate; for the
/// full convolution, whose winding numbers tell the sum of simply connected operands only, they
/// must be cut (simply_connected.hpp).
std::shared_ptr<const ArrangementTimeline> arrangement_timeline(
    const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
    ConvolutionType of = ConvolutionType::reduced);

}  // namespace minkref::inline plane
