// Those of millions of pair events that meet a condition.
#pragma once

#include "reference/plane/critical/edge_bounds.hpp"
#include "reference/plane/critical/event_condition.hpp"
#include "reference/plane/critical/pair_events.hpp"

namespace minkref {

/// Takes out of `events.events` all that do not meet the condition; ranks stay as they were among
/// all. Fields: "s", "rank", "x", "y" (the place of `event_places`), "kind" ("pair", "parallel"),
/// "change", and the parents; another one throws BadInput ("unknown-field"). Exact: scales are
/// found by bisection, of places doubles discard most. Some 10 ns an event and field, 10 us where a
/// place is too near to a bound. `P` and `Q`: the operands of the events.
void keep_events(PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                 const EventCondition& condition);

/// Where a pair event may be.
Enclosure place_bounds(const PairEvent& event, const EdgeBounds& bounds, int coordinate);

/// Different scales among them.
std::size_t distinct_scales(const PairEvents& events);

/// The places of a sorted list whose numbers are in a range, as first and last + 1; `number` gives
/// those of the list, ascending. O(log n).
template <class Number>
std::pair<std::size_t, std::size_t> places_in_range(std::size_t count, const NumberRange& range,
                                                    const Number& number) {
  const auto first_where = [&](const auto& holds) {
    std::size_t low = 0, high = count;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (holds(middle)) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  };
  const NumberRange below{{}, range.high, true, range.with_high};
  const NumberRange above{range.low, {}, range.with_low, true};
  const std::size_t first = first_where([&](std::size_t i) { return above.holds(number(i)); });
  const std::size_t last = first_where([&](std::size_t i) { return !below.holds(number(i)); });
  return {first, std::max(first, last)};
}

}  // namespace minkref
