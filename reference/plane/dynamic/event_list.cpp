#include "reference/plane/dynamic/event_list.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace minkref::inline plane {

std::vector<ListedEvent> listed_events(const ArrangementEvents& events, const ScaleWindow& closed) {
  // Groups within the window.
  std::uint32_t first = 0, last = static_cast<std::uint32_t>(events.groups());
  if (closed.from) first = events.locate(*closed.from).before;
  if (closed.to) {
    const auto location = events.locate(*closed.to);
    last = location.before + (location.at ? 1 : 0);
  }
  std::vector<ListedEvent> list;
  const auto add = [&](ListedEvent::Kind kind, std::uint32_t group, std::size_t index,
                       std::uint32_t edge = 0) {
    if (group == EdgeNode::always || group < first || group >= last) return;
    list.push_back({kind, group, static_cast<std::uint32_t>(index), edge});
  };
  const auto& pairs = events.pairs().events;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    add(ListedEvent::Kind::pair, events.group_of_pair_event(i), i);
  }
  for (std::size_t i = 0; i < events.triples().size(); ++i) {
    add(ListedEvent::Kind::triple, events.group_of_triple(i), i);
  }
  // Ends that pass each other on one line: each place once.
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> known;
  for (const PairEvent& event : pairs) {
    if (!event.parallel) continue;
    const auto index = static_cast<std::size_t>(&event - pairs.data());
    known.emplace(events.group_of_pair_event(index), event.a, event.b);
  }
  const NodeTable& table = events.table();
  for (std::uint32_t e = 0; e < events.edges().size(); ++e) {
    for (std::uint32_t n = table.begin(e); n < table.end(e); ++n) {
      const EdgeNode& node = table.nodes[n];
      if (node.kind == EdgeNode::Kind::crossing) continue;
      for (const std::uint32_t group : {node.from, node.to}) {
        if (group == EdgeNode::always) continue;
        if (!known.emplace(group, std::min(e, node.other), std::max(e, node.other)).second) {
          continue;
        }
        add(ListedEvent::Kind::passing, group, n, e);
      }
    }
  }
  std::stable_sort(list.begin(), list.end(), [](const ListedEvent& x, const ListedEvent& y) {
    return std::tie(x.group, x.kind) < std::tie(y.group, y.kind);
  });
  return list;
}

}  // namespace minkref::inline plane
