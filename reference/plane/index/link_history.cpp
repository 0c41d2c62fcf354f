#include "reference/plane/index/link_history.hpp"

#include <algorithm>
#include <numeric>

namespace minkref::inline plane {

LinkHistory::LinkHistory(const SweptBoundary& swept, const MovingBoundary& boundary,
                         const EdgeDirections& directions,
                         const std::vector<BoundaryAtEvent>& at_events, const RingOrder& order,
                         const BuildControl& control)
    : swept_(swept),
      boundary_(boundary),
      directions_(directions),
      at_events_(at_events),
      order_(order),
      control_(control),
      groups_(boundary.events.size()),
      ring_of_link_(boundary.links.size()) {
  std::iota(groups_.begin(), groups_.end(), 0U);
  sort_by_interval();
}

std::optional<BoundaryHistory::Quiet> LinkHistory::quiet(std::uint32_t group) const {
  control_.look();
  const RingChange& change = order_.changes[group];
  if (!at_events_[group].is_plain() || !change.same_rings) return std::nullopt;
  if (change.same_vertices) return Quiet{};
  return Quiet{change.more_vertices > 0   ? BoundaryEvent::Change::birth
               : change.more_vertices < 0 ? BoundaryEvent::Change::death
                                          : BoundaryEvent::Change::swap};
}

std::size_t LinkHistory::bucket_of(std::uint32_t interval) const {
  return static_cast<std::size_t>(
      std::partition_point(order_.buckets.begin(), order_.buckets.end(),
                           [&](const RingBucket& bucket) { return bucket.last < interval; }) -
      order_.buckets.begin());
}

std::uint32_t LinkHistory::ring_of(std::uint32_t link, std::uint32_t interval) const {
  if (bucket_ == SIZE_MAX || order_.buckets[bucket_].last < interval ||
      order_.buckets[bucket_].first > interval) {
    bucket_ = bucket_of(interval);
    const RingBucket& bucket = order_.buckets[bucket_];
    std::uint32_t ring = 0;
    for (std::uint32_t k = 0; k < bucket.entries.size(); ++k) {
      while (k >= bucket.ring_ends[ring]) ++ring;
      ring_of_link_[bucket.entries[k].link] = ring;
    }
  }
  return ring_of_link_[link];
}

}  // namespace minkref::inline plane
