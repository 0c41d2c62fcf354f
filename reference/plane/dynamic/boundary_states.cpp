#include "reference/plane/dynamic/boundary_states.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <unordered_map>

namespace minkref::inline plane {
namespace {

std::uint64_t key_of(std::uint32_t edge, std::uint32_t node) {
  return std::uint64_t{edge} << 32 | node;
}

/// The range of a group's items within a list sorted by group.
template <class T, class Group>
std::pair<std::size_t, std::size_t> of_group(const std::vector<T>& items, std::uint32_t group,
                                             Group&& group_of) {
  const auto first = std::partition_point(items.begin(), items.end(),
                                          [&](const T& x) { return group_of(x) < group; });
  auto last = first;
  while (last != items.end() && group_of(*last) == group) ++last;
  return {static_cast<std::size_t>(first - items.begin()),
          static_cast<std::size_t>(last - items.begin())};
}

}  // namespace

BoundaryStates::BoundaryStates(std::shared_ptr<const ArrangementTimeline> timeline)
    : timeline_(std::move(timeline)), directions_(edge_directions(timeline_->events->moving())) {
  std::map<std::array<Rational, 4>, std::uint32_t> track_of_value;
  const auto track = [&](std::uint32_t edge, std::uint32_t node) {
    const auto [place, fresh] = track_of_node_.try_emplace(key_of(edge, node), 0U);
    if (!fresh) return place->second;
    const Track value = timeline_->track(edge, node);
    const auto [known, is_new] = track_of_value.try_emplace(
        {value.a.x, value.a.y, value.b.x, value.b.y}, static_cast<std::uint32_t>(tracks_.size()));
    if (is_new) tracks_.push_back(value);
    return place->second = known->second;
  };
  for (const SubEdge& s : timeline_->sub_edges) {
    const std::uint32_t from = track(s.edge, s.from), to = track(s.edge, s.to);
    links_.push_back({from, to, s.edge, s.first, s.last});
    if (s.first > 0) groups_.push_back(s.first - 1);
    if (s.last < timeline_->events->groups()) groups_.push_back(s.last);
  }
  for (const SubEdgeAtGroup& piece : timeline_->at_groups) {
    track(piece.edge, piece.from);
    track(piece.edge, piece.to);
    groups_.push_back(piece.group);
  }
  for (const CoincidentNodes& block : timeline_->coincident) {
    for (const std::uint32_t node : block.nodes) track(block.edge, node);
    groups_.push_back(block.group);
  }
  std::sort(groups_.begin(), groups_.end());
  groups_.erase(std::unique(groups_.begin(), groups_.end()), groups_.end());
  sort_by_interval();
}

bool BoundaryStates::touches_boundary(std::uint32_t group) const {
  return std::binary_search(groups_.begin(), groups_.end(), group);
}

std::uint32_t BoundaryStates::track_of(std::uint32_t edge, std::uint32_t node) const {
  return track_of_node_.at(key_of(edge, node));
}

BoundaryAtGroup BoundaryStates::at_group(std::uint32_t group) const {
  // Coincident tracks: the least represents each.
  std::unordered_map<std::uint32_t, std::uint32_t> parent;
  const auto find = [&](std::uint32_t track) {
    for (auto at = parent.find(track); at != parent.end(); at = parent.find(track)) {
      track = at->second;
    }
    return track;
  };
  const auto blocks = of_group(timeline_->coincident, group, [](const auto& b) { return b.group; });
  for (std::size_t i = blocks.first; i < blocks.second; ++i) {
    const CoincidentNodes& block = timeline_->coincident[i];
    for (std::size_t k = 1; k < block.nodes.size(); ++k) {
      const std::uint32_t a = find(track_of(block.edge, block.nodes[k - 1]));
      const std::uint32_t b = find(track_of(block.edge, block.nodes[k]));
      if (a != b) parent[std::max(a, b)] = std::min(a, b);
    }
  }
  // Ends of pieces along edges that overlap at this scale only.
  const auto pieces = of_group(timeline_->at_groups, group, [](const auto& p) { return p.group; });
  if (pieces.second - pieces.first > 1) {
    const Rational scale = timeline_->events->exact(group);
    std::map<std::array<Rational, 2>, std::uint32_t> known;
    for (std::size_t i = pieces.first; i < pieces.second; ++i) {
      const SubEdgeAtGroup& piece = timeline_->at_groups[i];
      for (const std::uint32_t node : {piece.from, piece.to}) {
        const std::uint32_t a = find(track_of(piece.edge, node));
        const Point point = tracks_[a].at(scale);
        const auto [place, fresh] = known.try_emplace({point.x, point.y}, a);
        const std::uint32_t b = find(place->second);
        if (a != b) parent[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  BoundaryAtGroup here;
  for (const auto& [track, other] : parent) here.merged.emplace_back(track, find(track));
  std::sort(here.merged.begin(), here.merged.end());
  const auto cut = of_group(timeline_->interrupted, group, [](const auto& c) { return c.first; });
  for (std::size_t i = cut.first; i < cut.second; ++i) {
    here.interrupted.push_back(timeline_->interrupted[i].second);
  }
  std::sort(here.interrupted.begin(), here.interrupted.end());
  for (std::size_t i = pieces.first; i < pieces.second; ++i) {
    const SubEdgeAtGroup& piece = timeline_->at_groups[i];
    here.pieces.push_back({find(track_of(piece.edge, piece.from)),
                           find(track_of(piece.edge, piece.to)), piece.edge, piece.before,
                           piece.after});
  }
  return here;
}

BoundaryGraph boundary_graph(const std::vector<Track>& tracks, BoundaryState state,
                             CycleFinder& cycles, const Rational& scale) {
  cycles.remove_duplicates(state.links);
  cycles.find(state.links, true);  // throws unless the links close
  BoundaryGraph graph;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  number.reserve(2 * state.links.size());
  const auto point = [&](std::uint32_t track) {
    const auto [place, fresh] =
        number.try_emplace(track, static_cast<std::uint32_t>(graph.points.size()));
    if (fresh) graph.points.push_back(tracks[track].at(scale));
    return place->second;
  };
  for (const BoundaryLink& link : state.links) {
    const std::uint32_t from = point(link.from);
    graph.edges.emplace_back(from, point(link.to));
  }
  return graph;
}

}  // namespace minkref::inline plane
