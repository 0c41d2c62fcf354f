// The sorted scales of all events of pairs of convolution edges.
#pragma once

#include <vector>

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// Distinct scales within an open window, ascending: scales of pair and parallel events, and scales
/// at which end points of edges on one line pass each other.
class Moments {
 public:
  Moments(const PairEvents& events, const std::vector<RationalEdge>& edges)
      : events_(events), edges_(edges) {}

  std::size_t size() const { return approximate_.size(); }
  double approximate(std::uint32_t moment) const { return approximate_[moment]; }
  /// Some 2 us.
  Rational exact(std::uint32_t moment) const;
  /// An event at the moment, or none.
  const PairEvent* event(std::uint32_t moment) const {
    const std::int64_t event = source_[moment].event;
    return event < 0 ? nullptr : &events_.events[static_cast<std::size_t>(event)];
  }

  /// Adds the moment of a run of equal-ranked events that begins at `event`.
  std::uint32_t add_events(std::size_t event);
  /// The moment of a scale, known or new.
  std::uint32_t add_scale(const Rational& scale);

 private:
  struct Source {
    std::int64_t event;  ///< or -1 - index into extra_
  };
  const PairEvents& events_;
  const std::vector<RationalEdge>& edges_;
  std::vector<double> approximate_;
  std::vector<Source> source_;
  std::size_t from_events_ = 0;
  std::vector<Rational> extra_;
};

}  // namespace minkref::inline plane
