// The facets of the convolution that meet, followed from scale to scale by the events between.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "reference/space/critical/critical_events.hpp"

namespace minkref::inline space {

using FacetPair = std::pair<std::uint32_t, std::uint32_t>;

/// Returns all pairs of facets with a common point at a scale s > 0, ascending. Exact, from
/// scratch: boxes, then the pairs whose boxes meet.
std::vector<FacetPair> meeting_pairs_at(const MovingConvolution& convolution, const Rational& s);

/// The enumerative method (Sec. 5 and 7.2) up to the intersections: starts from the pairs that meet
/// at one scale, and follows the events to another scale.
class CrossingFacets {
 public:
  /// `start` and all later scales must lie within the events' window and off every event's scale:
  /// else BadInput ("at-an-event").
  CrossingFacets(std::shared_ptr<const CriticalEvents> events, const Rational& start);

  /// Returns the number of events on the way, each examined. O(k), beside a search for s.
  std::uint64_t move_to(const Rational& s);

  std::uint64_t count() const { return count_; }
  std::vector<FacetPair> pairs() const;

 private:
  std::size_t place_of(const Rational& s) const;

  std::shared_ptr<const CriticalEvents> events_;
  std::vector<FacetPair> all_;          ///< that meet at some scale
  std::vector<std::uint32_t> numbers_;  ///< for each event, of its pair
  std::vector<std::uint8_t> meets_;     ///< for each pair
  std::size_t place_;                   ///< so many events are behind
  std::uint64_t count_ = 0;
};

}  // namespace minkref::inline space
