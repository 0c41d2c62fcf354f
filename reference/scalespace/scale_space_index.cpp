#include "reference/scalespace/scale_space_index.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "reference/error.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/scalespace/slice.hpp"

namespace minkref {
namespace {

using V = Vector2<Rational>;

/// The same for vectors in the same direction: over the sum of the magnitudes of its coordinates.
V normalized(const V& d) {
  const Rational length = abs(d.x()) + abs(d.y());
  return {Rational(d.x() / length), Rational(d.y() / length)};
}

struct Before {
  bool operator()(const V& a, const V& b) const {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  }
};

}  // namespace

ScaleSpaceIndex::ScaleSpaceIndex(const PolygonSet& P, const PolygonSet& Q,
                                 const ScaleWindow& window, unsigned threads)
    : swept_(swept_boundary(P, Q, window, threads)),
      boundary_(moving_boundary(swept_)),
      buckets_(ring_buckets(swept_, boundary_)) {
  for (const Rational& event : boundary_.events) near_events_.push_back(to_double(event));
  bucket_.resize(boundary_.events.size() + 1);
  for (std::uint32_t b = 0; b < buckets_.size(); ++b) {
    for (std::uint32_t k = buckets_[b].first; k <= buckets_[b].last; ++k) bucket_[k] = b;
  }
  for (const Track& track : boundary_.tracks) {
    rounded_.push_back(
        {to_double(track.a.x), to_double(track.a.y), to_double(track.b.x), to_double(track.b.y)});
    const TrackInDoubles& r = rounded_.back();
    for (const double c : {r.x0, r.y0, r.x1, r.y1}) largest_ = std::max(largest_, std::fabs(c));
  }
  std::map<V, std::uint32_t, Before> numbers;
  for (const RationalEdge& edge : swept_.moving) {
    direction_.push_back(
        numbers.try_emplace(normalized(edge.d), static_cast<std::uint32_t>(numbers.size()))
            .first->second);
  }
  for (const RingBucket& bucket : buckets_) {
    std::vector<RoundedEntry>& entries = entries_.emplace_back();
    for (const RingEntry& entry : bucket.entries) {
      const MovingLink& link = boundary_.links[entry.link];
      entries.push_back({entry.first, entry.last, link.from, direction_[link.edge]});
    }
  }
}

ScaleSpaceIndex::Place ScaleSpaceIndex::place(const Rational& scale) const {
  const ScaleWindow& window = swept_.window;
  if (scale <= 0 || (window.from && scale < *window.from) || (window.to && scale > *window.to)) {
    throw BadInput("outside-window", "the index does not hold the scale " + to_string(scale),
                   "ask for a scale of its window, or build an index of a larger one");
  }
  const double near = to_double(scale), doubt = 0x1p-50 * near;
  auto at = static_cast<std::size_t>(
      std::lower_bound(near_events_.begin(), near_events_.end(), near - doubt) -
      near_events_.begin());
  while (at < near_events_.size() && near_events_[at] <= near + doubt &&
         boundary_.events[at] < scale) {
    ++at;
  }
  const bool at_event = at < boundary_.events.size() && near_events_[at] <= near + doubt &&
                        boundary_.events[at] == scale;
  return {static_cast<std::uint32_t>(at), at_event};
}

Sum ScaleSpaceIndex::sum(const Rational& scale) const {
  const Place at = place(scale);
  const ScaleWindow& window = swept_.window;
  if (at.at_event || (window.from && scale == *window.from) || (window.to && scale == *window.to)) {
    return slice(swept_, scale);
  }
  BoundaryGraph graph;
  std::vector<std::uint32_t> number(boundary_.tracks.size(), UINT32_MAX);
  const auto point = [&](std::uint32_t track) {
    if (number[track] == UINT32_MAX) {
      number[track] = static_cast<std::uint32_t>(graph.points.size());
      graph.points.push_back(boundary_.tracks[track].at(scale));
    }
    return number[track];
  };
  for (const RingEntry& entry : bucket_of(at.interval).entries) {
    if (entry.first > at.interval || entry.last < at.interval) continue;
    const MovingLink& link = boundary_.links[entry.link];
    const std::uint32_t from = point(link.from);
    graph.edges.emplace_back(from, point(link.to));
  }
  Canonical found = canonical_form(graph);
  return {std::move(found.region), found.components, found.holes, {}, std::nullopt};
}

void ScaleSpaceIndex::rings(std::uint32_t interval, double scale, RoundedRings& rings) const {
  const RingBucket& bucket = bucket_of(interval);
  const std::vector<RoundedEntry>& entries = entries_[bucket_[interval]];
  rings.x.resize(entries.size());
  rings.y.resize(entries.size());
  rings.ring_ends.clear();
  std::size_t count = 0, at = 0;
  for (const std::uint32_t end : bucket.ring_ends) {
    const std::size_t ring = count;
    std::uint32_t first_direction = UINT32_MAX, direction = UINT32_MAX;
    for (; at < end; ++at) {
      const RoundedEntry& entry = entries[at];
      if (interval - entry.first > entry.last - entry.first) continue;
      const TrackInDoubles& track = rounded_[entry.track];
      rings.x[count] = track.x0 + scale * track.x1;
      rings.y[count] = track.y0 + scale * track.y1;
      count += entry.direction != direction;
      direction = entry.direction;
      if (first_direction == UINT32_MAX) first_direction = direction;
    }
    if (count == ring) continue;
    if (direction == first_direction) {  // the first vertex is straight
      std::copy(rings.x.begin() + static_cast<std::ptrdiff_t>(ring) + 1,
                rings.x.begin() + static_cast<std::ptrdiff_t>(count),
                rings.x.begin() + static_cast<std::ptrdiff_t>(ring));
      std::copy(rings.y.begin() + static_cast<std::ptrdiff_t>(ring) + 1,
                rings.y.begin() + static_cast<std::ptrdiff_t>(count),
                rings.y.begin() + static_cast<std::ptrdiff_t>(ring));
      --count;
    }
    rings.ring_ends.push_back(static_cast<std::uint32_t>(count));
  }
  rings.x.resize(count);
  rings.y.resize(count);
  // Coefficients and the scale are rounded once each, a product and a sum once more.
  rings.error = 0x1p-50 * largest_ * (1 + scale);
}

}  // namespace minkref
