// The boundary of the sum between two groups of events, and at the scale of one.
#pragma once

#include <memory>

#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/dynamic/arrangement_timeline.hpp"
#include "reference/plane/dynamic/boundary_cycles.hpp"

namespace minkref {

/// Boundary links between points; a point is a track, or several tracks that coincide.
struct BoundaryState {
  std::vector<BoundaryLink> links;  ///< `before` and `after`: sub-edges, or no_sub_edge
};

/// Tracks of the nodes that the boundary has at some scale, each once, and the links of any state.
class BoundaryStates {
 public:
  explicit BoundaryStates(std::shared_ptr<const ArrangementTimeline> timeline);

  const ArrangementTimeline& timeline() const { return *timeline_; }
  const std::vector<Track>& tracks() const { return tracks_; }
  std::uint32_t from(std::uint32_t sub_edge) const { return from_[sub_edge]; }
  std::uint32_t to(std::uint32_t sub_edge) const { return to_[sub_edge]; }

  /// Groups at which a sub-edge of the boundary begins, ends, or is touched; ascending.
  const std::vector<std::uint32_t>& groups() const { return groups_; }
  bool touches_boundary(std::uint32_t group) const;

  /// The sub-edges of an interval of scales.
  std::vector<std::uint32_t> sub_edges_in(std::uint32_t interval) const;
  /// Sub-edges that begin with an interval, and those that end with it.
  const std::vector<std::uint32_t>& begin_with(std::uint32_t interval) const;
  const std::vector<std::uint32_t>& end_with(std::uint32_t interval) const;

  /// Of an interval with these sub-edges. Duplicates included.
  BoundaryState between(const std::vector<std::uint32_t>& sub_edges) const;
  /// At the scale of a group, from the sub-edges of the interval before it. Duplicates included.
  BoundaryState at_group(std::uint32_t group, const std::vector<std::uint32_t>& sub_edges) const;

 private:
  std::uint32_t track_of(std::uint32_t edge, std::uint32_t node) const;

  std::shared_ptr<const ArrangementTimeline> timeline_;
  std::vector<Track> tracks_;
  std::vector<std::uint32_t> from_, to_;
  std::vector<std::uint32_t> groups_;
  struct Known;
  std::shared_ptr<Known> known_;
};

/// The points of a state at a scale, and its links without duplicates. Exact.
BoundaryGraph boundary_graph(const BoundaryStates& states, BoundaryState state, CycleFinder& cycles,
                             const Rational& scale);

}  // namespace minkref
