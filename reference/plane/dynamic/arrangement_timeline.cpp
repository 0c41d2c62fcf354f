#include "reference/plane/dynamic/arrangement_timeline.hpp"

#include <algorithm>
#include <numeric>

#include "reference/number/float_environment.hpp"
#include "reference/plane/dynamic/edge_sweep.hpp"

namespace minkref::inline plane {
namespace {

/// By a small integer key, stable: counting sort.
template <class T, class Key>
void sort_by(std::vector<T>& items, std::size_t keys, Key&& key) {
  std::vector<std::size_t> first(keys + 1, 0);
  for (const T& item : items) ++first[key(item) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<T> sorted(items.size());
  for (T& item : items) {
    const std::size_t place = first[key(item)]++;
    sorted[place] = std::move(item);
  }
  items = std::move(sorted);
}

/// Sorted by step.
void pack_changes(std::vector<NodeChange>& changes, std::size_t steps,
                  ArrangementTimeline& timeline) {
  sort_by(changes, steps, [](const NodeChange& c) { return c.step; });
  timeline.first_change.assign(steps + 1, 0);
  for (const NodeChange& change : changes) ++timeline.first_change[change.step + 1];
  std::partial_sum(timeline.first_change.begin(), timeline.first_change.end(),
                   timeline.first_change.begin());
  timeline.changes.reserve(changes.size());
  for (const NodeChange& change : changes) timeline.changes.emplace_back(change);
  changes = {};
}

}  // namespace

std::shared_ptr<const ArrangementTimeline> arrangement_timeline(const PolygonSet& P,
                                                                const PolygonSet& Q,
                                                                const ScaleWindow& window,
                                                                ConvolutionType of) {
  const FloatEnvironment standard;
  auto events = std::make_shared<ArrangementEvents>(P, Q, window, of);
  EdgeHistory history;
  EdgeSweep sweep(P, Q, *events, of);
  for (std::uint32_t e = 0; e < events->edges().size(); ++e) sweep.sweep(e, history);
  const std::size_t groups = events->groups();
  sort_by(history.at_groups, groups, [](const SubEdgeAtGroup& c) { return c.group; });
  sort_by(history.interrupted, groups, [](const auto& c) { return c.first; });
  sort_by(history.coincident, groups, [](const CoincidentNodes& c) { return c.group; });

  auto timeline = std::make_shared<ArrangementTimeline>();
  timeline->initial = std::move(history.initial);
  pack_changes(history.changes, 2 * groups, *timeline);
  timeline->sub_edges = std::move(history.sub_edges);
  timeline->at_groups = std::move(history.at_groups);
  timeline->interrupted = std::move(history.interrupted);
  timeline->coincident = std::move(history.coincident);
  timeline->winding = std::move(history.winding);
  timeline->decided_by_doubles = history.decided_by_doubles;
  timeline->decided_exactly = history.decided_exactly;
  const NodeTable& table = events->table();
  timeline->edge_of_node.resize(table.nodes.size());
  for (std::uint32_t e = 0; e < events->edges().size(); ++e) {
    std::fill(timeline->edge_of_node.begin() + table.begin(e),
              timeline->edge_of_node.begin() + table.end(e), e);
  }
  timeline->events = std::move(events);
  return timeline;
}

}  // namespace minkref::inline plane
