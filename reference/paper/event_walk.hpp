// The sorted array of events, and the walk along it up or down (Behar & Lien 2012, Sec. 4.2.4).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/number/scalar.hpp"

namespace minkref {

/// One way along the array of events.
struct WalkStep {
  std::uint64_t insertions = 0, deletions = 0;
  std::uint64_t updated = 0;  ///< intersections at the scale reached
};

/// Sorted ends of closed regions of scales, with a current place. A Region has optional bounds
/// `lower` and `upper`, of T; no bound means down to 0 or up to infinity.
template <class T, class Region>
class EventWalk {
 public:
  struct Event {
    std::uint32_t region;
    bool insertion;
  };

  /// Sorts ascending; at equal scales insertions come first, for regions are closed. `regions` must
  /// outlive it. O(n log n).
  explicit EventWalk(const std::vector<Region>& regions) : regions_(regions) {
    for (std::uint32_t i = 0; i < regions_.size(); ++i) {
      if (regions_[i].lower) events_.push_back({i, true});
      if (regions_[i].upper) events_.push_back({i, false});
    }
    std::stable_sort(events_.begin(), events_.end(), [&](const Event& x, const Event& y) {
      look_for_interrupt();
      const int order = sign(T(scale_of(x) - scale_of(y)));
      return order != 0 ? order < 0 : x.insertion && !y.insertion;
    });
  }

  /// Calls insert(region, scale) for every region that holds the first scale. O(n).
  template <class Insert>
  void start(const T& scale, Insert&& insert) {
    scale_ = scale;
    while (next_ < events_.size() && is_due(events_[next_], scale)) ++next_;
    for (std::uint32_t i = 0; i < regions_.size(); ++i) {
      look_for_interrupt();
      const Region& region = regions_[i];
      if (region.lower && sign(T(*region.lower - scale)) > 0) continue;
      if (region.upper && sign(T(*region.upper - scale)) < 0) continue;
      insert(i, scale);
      ++active_;
    }
  }

  /// Calls insert(region, event's scale) and erase(region) for the events on the way to a scale, up
  /// or down. O(events crossed).
  template <class Insert, class Erase>
  WalkStep move_to(const T& scale, Insert&& insert, Erase&& erase) {
    WalkStep step;
    const auto apply = [&](const Event& event, bool insertion) {
      if (insertion) {
        insert(event.region, scale_of(event));
        ++step.insertions;
        ++active_;
      } else {
        erase(event.region);
        ++step.deletions;
        --active_;
      }
    };
    while (next_ < events_.size() && is_due(events_[next_], scale)) {
      apply(events_[next_], events_[next_].insertion);
      ++next_;
    }
    while (next_ > 0 && !is_due(events_[next_ - 1], scale)) {
      --next_;
      apply(events_[next_], !events_[next_].insertion);
    }
    scale_ = scale;
    step.updated = active_;
    return step;
  }

  const std::vector<Event>& events() const { return events_; }
  const T& scale_of(const Event& event) const {
    const Region& region = regions_[event.region];
    return event.insertion ? *region.lower : *region.upper;
  }
  /// The scale that was reached.
  const T& scale() const { return scale_; }

 private:
  /// Whether the walk upwards to a scale crosses the event: regions are closed.
  bool is_due(const Event& event, const T& scale) const {
    const int order = sign(T(scale_of(event) - scale));
    return event.insertion ? order <= 0 : order < 0;
  }

  const std::vector<Region>& regions_;
  std::vector<Event> events_;
  std::size_t next_ = 0;
  std::uint64_t active_ = 0;
  T scale_{};
};

}  // namespace minkref
