// The sum's boundary between two groups of events, and at a group's scale.
#pragma once

#include <memory>
#include <unordered_map>

#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/dynamic/arrangement_timeline.hpp"
#include "reference/plane/history/boundary_history.hpp"

namespace minkref::inline plane {

/// Tracks of all nodes on the boundary at some scale, each once, and the links of any state.
class BoundaryStates : public BoundaryHistory {
 public:
  explicit BoundaryStates(std::shared_ptr<const ArrangementTimeline> timeline);

  const ArrangementTimeline& timeline() const { return *timeline_; }
  bool touches_boundary(std::uint32_t group) const;

  const std::vector<Track>& tracks() const override { return tracks_; }
  const std::vector<RationalEdge>& moving() const override { return timeline_->events->moving(); }
  const EdgeDirections& directions() const override { return directions_; }
  const ScaleWindow& window() const override { return timeline_->events->window(); }
  std::uint32_t group_count() const override {
    return static_cast<std::uint32_t>(timeline_->events->groups());
  }
  Rational scale(std::uint32_t group) const override { return timeline_->events->exact(group); }
  const std::vector<std::uint32_t>& groups() const override { return groups_; }
  const std::vector<MovingLink>& sub_edges() const override { return links_; }
  BoundaryAtGroup at_group(std::uint32_t group) const override;

 private:
  std::uint32_t track_of(std::uint32_t edge, std::uint32_t node) const;

  std::shared_ptr<const ArrangementTimeline> timeline_;
  EdgeDirections directions_;
  std::vector<Track> tracks_;
  std::vector<MovingLink> links_;  ///< the sub-edges of the timeline
  std::vector<std::uint32_t> groups_;
  std::unordered_map<std::uint64_t, std::uint32_t> track_of_node_;
};

/// A state's points at a scale, and its links without duplicates. Exact.
BoundaryGraph boundary_graph(const std::vector<Track>& tracks, BoundaryState state,
                             CycleFinder& cycles, const Rational& scale);

}  // namespace minkref::inline plane
