#include "reference/plane/dynamic/edge_happenings.hpp"

#include <tuple>

namespace minkref::inline plane {
namespace {

template <class Add>
void report_swaps(const ArrangementEvents& events, Add&& add) {
  for (std::size_t t = 0; t < events.triples().size(); ++t) {
    const TripleEvent& triple = events.triples()[t];
    const std::uint32_t group = events.group_of_triple(t);
    const auto along = [&](int bit, std::uint32_t e, std::uint32_t f, std::uint32_t g) {
      if (triple.swaps >> bit & 1) add(e, {Happening::Kind::swap, group, f, g});
    };
    along(0, triple.a, triple.b, triple.c);
    along(1, triple.b, triple.a, triple.c);
    along(2, triple.c, triple.a, triple.b);
  }
}

template <class Add>
void report_overlaps(const ArrangementEvents& events, Add&& add) {
  for (std::size_t i = 0; i < events.pairs().events.size(); ++i) {
    const PairEvent& event = events.pairs().events[i];
    if (!event.parallel || event.change != Change::overlap) continue;
    const std::uint32_t group = events.group_of_pair_event(i);
    if (group == EdgeNode::always) continue;
    add(event.a, {Happening::Kind::overlap, group, event.b, 0});
    add(event.b, {Happening::Kind::overlap, group, event.a, 0});
  }
}

}  // namespace

EdgeHappenings::EdgeHappenings(const ArrangementEvents& events)
    : events_(events), shared_(events.edges().size(), [&](auto&& add) {
        report_swaps(events, add);
        report_overlaps(events, add);
      }) {}

void EdgeHappenings::of(std::uint32_t edge, std::vector<Happening>& happenings) const {
  const std::span<const Happening> shared = shared_.of(edge);
  happenings.assign(shared.begin(), shared.end());
  const NodeTable& table = events_.table();
  for (std::uint32_t n = table.begin(edge); n < table.end(edge); ++n) {
    const EdgeNode& node = table.nodes[n];
    const std::uint32_t local = n - table.begin(edge);
    if (node.from != EdgeNode::always)
      happenings.push_back({Happening::Kind::arrival, node.from, local, 0});
    if (node.to != EdgeNode::always)
      happenings.push_back({Happening::Kind::departure, node.to, local, 0});
  }
  std::sort(happenings.begin(), happenings.end(), [](const Happening& x, const Happening& y) {
    return std::tie(x.group, x.kind, x.first, x.second) <
           std::tie(y.group, y.kind, y.first, y.second);
  });
}

}  // namespace minkref::inline plane
