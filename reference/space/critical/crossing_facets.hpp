// Which facets of the convolution meet, from scale to scale by the events in between.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "reference/space/critical/critical_events.hpp"

namespace minkref::inline space {

using FacetPair = std::pair<std::uint32_t, std::uint32_t>;

/// All pairs of facets that have a point in common at a scale s > 0, ascending. Exact, from
/// scratch: boxes, then the pairs whose boxes meet.
std::vector<FacetPair> meeting_pairs_at(const MovingConvolution& convolution, const Rational& s);

/// The enumerative method of Sec. 5 and 7.2 without what follows the intersections: starts from the
/// pairs that meet at one scale, and updates them by the events up to another one.
class CrossingFacets {
 public:
  /// `start` and all scales that follow are in the window of the events, and are no scale of an
  /// event: else BadInput ("at-an-event").
  CrossingFacets(std::shared_ptr<const CriticalEvents> events, const Rational& start);

  /// How many events there are on the way; each is looked at. O(k), beside a search for s.
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
