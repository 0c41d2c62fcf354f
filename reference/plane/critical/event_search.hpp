// A search through a long list of events, whatever the kind of list.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/critical/event_condition.hpp"

namespace minkref::inline plane {

/// The positions within a sorted list whose numbers lie inside a range, as first and last + 1;
/// `number` gives the list's numbers, ascending. O(log n).
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

/// The test of a condition on a field, for `count` events listed by scale. `List` says of the event
/// at position i: `scale(i)`, `rank(i)`, doubles about a coordinate of its place `about(i,
/// coordinate)`, its place `at(i)`, `kind(i)`, `change(i)`, and `has_edge(i, wanted)`, whether an
/// edge of the event is wanted; for all events together, `edges()` and `what()`. Throws BadInput
/// ("unknown-field") for any other field.
template <class List>
EventTest field_test(const List& list, std::size_t count, const EventCondition& c) {
  using Test = EventCondition::Test;
  if (c.test == Test::in_range && (c.field == "s" || c.field == "rank")) {
    const bool scales = c.field == "s";
    const auto [first, last] = places_in_range(count, c.range, [&](std::size_t i) {
      return scales ? list.scale(i) : Rational(list.rank(i));
    });
    return [first = first, last = last](std::size_t i) { return i >= first && i < last; };
  }
  if (c.test == Test::in_range && (c.field == "x" || c.field == "y")) {
    return [&list, range = c.range, quick = EnclosedNumbers(c.range),
            coordinate = c.field == "y" ? 1 : 0](std::size_t i) {
      const Enclosure about = list.about(i, coordinate);
      if (const auto known = quick.in_range(about.lower, about.upper)) return *known;
      const Point at = list.at(i);
      return range.holds(coordinate == 0 ? at.x : at.y);
    };
  }
  if (c.test == Test::one_of && c.field == "kind") {
    return [&list, c](std::size_t i) { return c.has_word(list.kind(i)); };
  }
  if (c.test == Test::one_of && c.field == "change") {
    return [&list, c](std::size_t i) { return c.has_word(list.change(i)); };
  }
  if (c.test == Test::has_edge) {
    return [&list, wanted = matching_edges(list.edges(), c.edge)](std::size_t i) {
      return list.has_edge(i, wanted);
    };
  }
  throw BadInput("unknown-field", std::string(list.what()) + " have no \"" + c.field + "\"",
                 "ask for another");
}

/// Removes from `events` all that do not meet the condition; `list` reads the same events.
template <class Event, class List>
void keep_those(std::vector<Event>& events, const List& list, const EventCondition& condition) {
  const EventTest test = event_test(condition, [&](const EventCondition& field) {
    return field_test(list, events.size(), field);
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    look_for_interrupt();
    if (test(i)) events[kept++] = events[i];  // tests an event before overwriting it
  }
  events.resize(kept);
  events.shrink_to_fit();
}

/// Different scales among sorted events.
template <class Event>
std::size_t distinct_scales(const std::vector<Event>& events) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    count += i == 0 || events[i].rank != events[i - 1].rank;
  }
  return count;
}

}  // namespace minkref::inline plane
