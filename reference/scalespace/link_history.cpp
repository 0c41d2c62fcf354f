#include "reference/scalespace/link_history.hpp"

#include <algorithm>
#include <numeric>

namespace minkref {

LinkHistory::LinkHistory(const SweptBoundary& swept, const MovingBoundary& boundary,
                         const std::vector<BoundaryAtEvent>& at_events, const RingOrder& order)
    : swept_(swept),
      boundary_(boundary),
      at_events_(at_events),
      order_(order),
      groups_(boundary.events.size()),
      begin_(boundary.events.size() + 1),
      end_(boundary.events.size() + 1),
      ring_of_link_(boundary.links.size()) {
  std::iota(groups_.begin(), groups_.end(), 0U);
  for (std::uint32_t k = 0; k < boundary.links.size(); ++k) {
    begin_[boundary.links[k].first].push_back(k);
    end_[boundary.links[k].last].push_back(k);
  }
}

std::vector<std::uint32_t> LinkHistory::sub_edges_in(std::uint32_t interval) const {
  std::vector<std::uint32_t> result;
  for (std::uint32_t k = 0; k < boundary_.links.size(); ++k) {
    const MovingLink& link = boundary_.links[k];
    if (link.first <= interval && interval <= link.last) result.push_back(k);
  }
  return result;
}

BoundaryState LinkHistory::between(const std::vector<std::uint32_t>& sub_edges) const {
  BoundaryState state;
  for (const std::uint32_t k : sub_edges) {
    const MovingLink& link = boundary_.links[k];
    state.links.push_back({link.from, link.to, link.edge, k, k});
  }
  return state;
}

BoundaryState LinkHistory::at_group(std::uint32_t group,
                                    const std::vector<std::uint32_t>& sub_edges) const {
  const BoundaryAtEvent& here = at_events_[group];
  BoundaryState state;
  for (const std::uint32_t k : sub_edges) {
    const MovingLink& link = boundary_.links[k];
    if (link.last <= group) continue;
    state.links.push_back(
        {here.standing_for(link.from), here.standing_for(link.to), link.edge, k, k});
  }
  for (const PieceAtEvent& piece : here.pieces) {
    state.links.push_back({piece.from, piece.to, piece.edge, piece.before, piece.after});
  }
  return state;
}

std::vector<std::uint32_t> LinkHistory::edges_at(std::uint32_t group) const {
  std::vector<std::uint32_t> edges;
  for (const auto* list : {&end_[group], &begin_[group + 1]}) {
    for (const std::uint32_t k : *list) edges.push_back(boundary_.links[k].edge);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::optional<Point> LinkHistory::place_at(std::uint32_t group) const {
  const BoundaryAtEvent& here = at_events_[group];
  std::optional<std::uint32_t> track;
  if (!here.merged.empty()) {
    track = here.merged.front().first;
  } else if (!end_[group].empty()) {
    track = boundary_.links[end_[group].front()].from;
  } else if (!begin_[group + 1].empty()) {
    track = boundary_.links[begin_[group + 1].front()].from;
  }
  if (!track) return std::nullopt;
  return boundary_.tracks[*track].at(boundary_.events[group]);
}

std::optional<BoundaryHistory::Quiet> LinkHistory::quiet(std::uint32_t group) const {
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

}  // namespace minkref
