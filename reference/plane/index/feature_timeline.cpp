#include "reference/plane/index/feature_timeline.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/no_entry.hpp"

namespace minkref::inline plane {
namespace {

/// Features that a bucket's rings bound from an interval on; component `no_entry` for absent rings.
struct Known {
  std::uint32_t interval;
  std::size_t bucket;
  std::vector<RingFeatures> rings;
};

/// Buckets with their features, cut at changes of features.
class Naming {
 public:
  Naming(const SweptBoundary& swept, const MovingBoundary& boundary)
      : turns_(swept.moving), boundary_(boundary) {}

  /// `known`: this bucket's features, sorted by interval.
  void add(RingBucket&& bucket, const std::vector<const Known*>& known) {
    std::vector<RingFeatures> features(bucket.ring_ends.size(), RingFeatures{false, 0, no_entry});
    for (const Known* now : known) {
      const auto differs = [&](std::size_t ring) {
        const RingFeatures &a = features[ring], &b = now->rings[ring];
        return a.component != no_entry && b.component != no_entry &&
               (a.component != b.component || a.hole != b.hole);
      };
      bool cut = false;
      for (std::size_t ring = 0; ring < features.size(); ++ring) cut = cut || differs(ring);
      if (cut) {
        finish(part(bucket, bucket.first, now->interval - 1, features));
        bucket.first = now->interval;
        features.assign(features.size(), RingFeatures{false, 0, no_entry});
      }
      for (std::size_t ring = 0; ring < features.size(); ++ring) {
        if (now->rings[ring].component != no_entry) features[ring] = now->rings[ring];
      }
    }
    finish(part(bucket, bucket.first, bucket.last, features));
  }

  std::vector<RingBucket> take() { return std::move(result_); }

 private:
  /// A bucket's part for some of its intervals.
  static RingBucket part(const RingBucket& bucket, std::uint32_t first, std::uint32_t last,
                         const std::vector<RingFeatures>& features) {
    RingBucket result;
    result.first = first;
    result.last = last;
    std::uint32_t k = 0;
    for (std::size_t ring = 0; ring < bucket.ring_ends.size(); ++ring) {
      const std::size_t before = result.entries.size();
      for (; k < bucket.ring_ends[ring]; ++k) {
        RingEntry entry = bucket.entries[k];
        entry.first = std::max(entry.first, first);
        entry.last = std::min(entry.last, last);
        if (entry.first <= entry.last) result.entries.push_back(entry);
      }
      if (result.entries.size() == before) continue;
      result.ring_ends.push_back(static_cast<std::uint32_t>(result.entries.size()));
      result.features.push_back(features[ring]);
    }
    return result;
  }

  void finish(RingBucket bucket) {
    std::uint32_t begin = 0;
    for (std::size_t ring = 0; ring < bucket.ring_ends.size(); ++ring) {
      if (bucket.features[ring].component == no_entry) {
        throw std::logic_error("a ring of the swept sum bounds nothing");
      }
      bucket.features[ring].is_hole = turns_right(bucket, begin, bucket.ring_ends[ring]);
      begin = bucket.ring_ends[ring];
    }
    result_.push_back(std::move(bucket));
  }

  bool turns_right(const RingBucket& bucket, std::uint32_t begin, std::uint32_t end) const {
    std::uint32_t interval = no_entry;
    for (std::uint32_t k = begin; k < end; ++k) {
      interval = std::min(interval, bucket.entries[k].first);
    }
    std::uint32_t first = no_entry, edge = no_entry;
    int turns = 0;
    for (std::uint32_t k = begin; k < end; ++k) {
      if (bucket.entries[k].first > interval || bucket.entries[k].last < interval) continue;
      const std::uint32_t own = boundary_.links[bucket.entries[k].link].edge;
      if (first == no_entry) {
        first = own;
      } else {
        turns += turns_.half_turns(edge, own);
      }
      edge = own;
    }
    return turns + turns_.half_turns(edge, first) < 0;
  }

  CycleFinder turns_;
  const MovingBoundary& boundary_;
  std::vector<RingBucket> result_;
};

}  // namespace

TopologyTimeline feature_timeline(const SweptBoundary& swept, const MovingBoundary& boundary,
                                  const EdgeDirections& directions,
                                  const std::vector<BoundaryAtEvent>& at_events, RingOrder& order,
                                  const BuildControl& control) {
  const LinkHistory history(swept, boundary, directions, at_events, order, control);
  std::vector<Known> all;
  const auto note = [&](const FeaturesFrom& state) {
    control.look_now();
    Known known{state.interval, history.bucket_of(state.interval), {}};
    known.rings.assign(order.buckets[known.bucket].ring_ends.size(), {false, 0, no_entry});
    for (std::size_t k = 0; k < state.sub_edges.size(); ++k) {
      const std::uint32_t ring = history.ring_of(state.sub_edges[k], state.interval);
      known.rings[ring] = {false, state.holes[k], state.components[k]};
    }
    all.push_back(std::move(known));
  };
  TopologyTimeline timeline = topology_timeline(history, {}, note);
  Naming naming(swept, boundary);
  std::size_t next = 0;
  for (std::size_t b = 0; b < order.buckets.size(); ++b) {
    control.look();
    std::vector<const Known*> known;
    for (; next < all.size() && all[next].bucket == b; ++next) known.push_back(&all[next]);
    naming.add(std::move(order.buckets[b]), known);
  }
  order.buckets = naming.take();
  return timeline;
}

}  // namespace minkref::inline plane
