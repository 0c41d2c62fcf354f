// The moving boundary as the history that holes and components follow.
#pragma once

#include "reference/plane/history/boundary_history.hpp"
#include "reference/plane/index/boundary_at_events.hpp"
#include "reference/plane/index/ring_order.hpp"

namespace minkref::inline plane {

/// A history whose sub-edges are links, and whose groups are events. An event is quiet if no point
/// is passed twice, no two links face each other, and the rings stay. All arguments have to outlive
/// the history. Not for several threads at once.
class LinkHistory : public BoundaryHistory {
 public:
  LinkHistory(const SweptBoundary& swept, const MovingBoundary& boundary,
              const EdgeDirections& directions, const std::vector<BoundaryAtEvent>& at_events,
              const RingOrder& order, const BuildControl& control);

  const std::vector<Track>& tracks() const override { return boundary_.tracks; }
  const std::vector<RationalEdge>& moving() const override { return swept_.moving; }
  const EdgeDirections& directions() const override { return directions_; }
  const ScaleWindow& window() const override { return swept_.window; }
  std::uint32_t group_count() const override {
    return static_cast<std::uint32_t>(boundary_.events.size());
  }
  Rational scale(std::uint32_t group) const override { return boundary_.events[group]; }
  const std::vector<std::uint32_t>& groups() const override { return groups_; }
  const std::vector<MovingLink>& sub_edges() const override { return boundary_.links; }
  BoundaryAtGroup at_group(std::uint32_t group) const override { return at_events_[group]; }
  std::optional<Quiet> quiet(std::uint32_t group) const override;
  /// The ring's number within its bucket.
  std::uint32_t ring_of(std::uint32_t link, std::uint32_t interval) const override;

  std::size_t bucket_of(std::uint32_t interval) const;

 private:
  const SweptBoundary& swept_;
  const MovingBoundary& boundary_;
  const EdgeDirections& directions_;
  const std::vector<BoundaryAtEvent>& at_events_;
  const RingOrder& order_;
  const BuildControl& control_;
  std::vector<std::uint32_t> groups_;
  mutable std::size_t bucket_ = SIZE_MAX;  ///< the bucket of the next member's rings
  mutable std::vector<std::uint32_t> ring_of_link_;
};

}  // namespace minkref::inline plane
