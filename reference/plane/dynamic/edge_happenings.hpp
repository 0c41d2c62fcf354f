// Each convolution edge's happenings, one group of events after another.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "reference/plane/dynamic/arrangement_events.hpp"

namespace minkref::inline plane {

struct Happening {
  enum class Kind : std::uint8_t { arrival, departure, swap, overlap } kind;
  std::uint32_t group;
  std::uint32_t first, second;  ///< local node; the other edges of a triple; the parallel edge
};

/// Items sorted by their edge.
template <class T>
class ByEdge {
 public:
  /// `report(add)` is called twice, and calls add(edge, item) for each item.
  template <class Report>
  ByEdge(std::size_t edges, Report&& report) : first_(edges + 1, 0) {
    report([&](std::uint32_t edge, const T&) { ++first_[edge + 1]; });
    for (std::size_t e = 0; e < edges; ++e) first_[e + 1] += first_[e];
    items_.resize(first_.back());
    std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
    report([&](std::uint32_t edge, const T& item) { items_[place[edge]++] = item; });
  }
  std::span<const T> of(std::uint32_t edge) const {
    return {items_.data() + first_[edge], items_.data() + first_[edge + 1]};
  }

 private:
  std::vector<T> items_;
  std::vector<std::uint32_t> first_;
};

/// All edges' happenings. O(events) to build.
class EdgeHappenings {
 public:
  explicit EdgeHappenings(const ArrangementEvents& events);

  /// Happenings sorted by group and kind. O(k log k).
  void of(std::uint32_t edge, std::vector<Happening>& happenings) const;

 private:
  const ArrangementEvents& events_;
  ByEdge<Happening> shared_;  ///< swaps and overlaps; arrivals and departures are in the node table
};

}  // namespace minkref::inline plane
