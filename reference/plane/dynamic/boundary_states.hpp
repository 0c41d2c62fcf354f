// The boundary of the sum between two groups of events, and at the scale of one.
#pragma once

#include <memory>
#include <span>

#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/dynamic/arrangement_timeline.hpp"
#include "reference/plane/dynamic/boundary_history.hpp"

namespace minkref {

/// Tracks of the nodes that the boundary has at some scale, each once, and the links of any state.
class BoundaryStates : public BoundaryHistory {
 public:
  explicit BoundaryStates(std::shared_ptr<const ArrangementTimeline> timeline);

  const ArrangementTimeline& timeline() const { return *timeline_; }
  std::uint32_t from(std::uint32_t sub_edge) const { return from_[sub_edge]; }
  std::uint32_t to(std::uint32_t sub_edge) const { return to_[sub_edge]; }
  bool touches_boundary(std::uint32_t group) const;

  const std::vector<Track>& tracks() const override { return tracks_; }
  const std::vector<RationalEdge>& moving() const override { return timeline_->events->moving(); }
  const ScaleWindow& window() const override { return timeline_->events->window(); }
  std::uint32_t group_count() const override {
    return static_cast<std::uint32_t>(timeline_->events->groups());
  }
  Rational scale(std::uint32_t group) const override { return timeline_->events->exact(group); }
  const std::vector<std::uint32_t>& groups() const override { return groups_; }
  std::size_t sub_edge_count() const override { return timeline_->sub_edges.size(); }
  std::vector<std::uint32_t> sub_edges_in(std::uint32_t interval) const override;
  const std::vector<std::uint32_t>& begin_with(std::uint32_t interval) const override;
  const std::vector<std::uint32_t>& end_with(std::uint32_t interval) const override;
  BoundaryState between(const std::vector<std::uint32_t>& sub_edges) const override;
  BoundaryState at_group(std::uint32_t group,
                         const std::vector<std::uint32_t>& sub_edges) const override;
  std::vector<std::uint32_t> edges_at(std::uint32_t group) const override;
  std::optional<Point> place_at(std::uint32_t group) const override;

 private:
  std::uint32_t track_of(std::uint32_t edge, std::uint32_t node) const;
  std::span<const CoincidentNodes> coincident_at(std::uint32_t group) const;

  std::shared_ptr<const ArrangementTimeline> timeline_;
  std::vector<Track> tracks_;
  std::vector<std::uint32_t> from_, to_;
  std::vector<std::uint32_t> groups_;
  struct Known;
  std::shared_ptr<Known> known_;
};

/// The points of a state at a scale, and its links without duplicates. Exact.
BoundaryGraph boundary_graph(const std::vector<Track>& tracks, BoundaryState state,
                             CycleFinder& cycles, const Rational& scale);

}  // namespace minkref
