// Scales of found events.
#include "reference/plane/dynamic/arrangement_events.hpp"

#include <algorithm>
#include <cmath>

#include "reference/plane/kernel/grid_kernel.hpp"

namespace minkref::inline plane {

Rational ArrangementEvents::exact(std::uint32_t group) const {
  const Source& source = source_[group];
  return source.kind == Source::Kind::moment
             ? moments_->exact(source.index)
             : triple_scale(triples_[source.index], moving_, table_);
}

const PairEvent* ArrangementEvents::pair_event_at(std::uint32_t group) const {
  const Source& source = source_[group];
  return source.kind == Source::Kind::moment ? moments_->event(source.index) : nullptr;
}

const TripleEvent* ArrangementEvents::triple_event_at(std::uint32_t group) const {
  const Source& source = source_[group];
  return source.kind == Source::Kind::triple ? &triples_[source.index] : nullptr;
}

std::span<const PairEvent> ArrangementEvents::pair_events_of(std::uint32_t group) const {
  const auto& all = pairs_.events;
  const auto group_of = [&](const PairEvent& event) { return group_of_rank_[event.rank]; };
  // Only the first rank and the last may lie outside the window.
  const auto first = std::partition_point(all.begin(), all.end(), [&](const PairEvent& event) {
    return group_of(event) == EdgeNode::always ? event.rank == 0 : group_of(event) < group;
  });
  auto last = first;
  while (last != all.end() && group_of(*last) == group) ++last;
  return {first, last};
}

ArrangementEvents::Location ArrangementEvents::locate(const Rational& scale) const {
  const double value = to_double(scale);
  const double reach = 4 * std::abs(value) * filter_bound + 1e-300;
  auto at = static_cast<std::uint32_t>(
      std::lower_bound(approximate_.begin(), approximate_.end(), value - reach) -
      approximate_.begin());
  for (; at < groups() && !(approximate_[at] > value + reach); ++at) {
    const Rational here = exact(at);
    if (here == scale) return {at, true};
    if (here > scale) return {at, false};
  }
  return {at, false};
}

}  // namespace minkref::inline plane
