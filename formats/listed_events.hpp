// Lists of arrangement events: searches, and JSON text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/event_row.hpp"
#include "reference/plane/critical/event_condition.hpp"
#include "reference/plane/dynamic/event_list.hpp"

namespace minkref {

/// An event of a list, with the count of different lower scales on the list.
struct RankedEvent {
  ListedEvent event;
  std::uint32_t rank = 0;
};

/// "pair", "parallel" or "triple".
std::string_view kind_name(const ArrangementEvents& events, const ListedEvent& event);
/// "birth", "death", "touch", "overlap" or "swap".
std::string_view change_name(const ArrangementEvents& events, const ListedEvent& event);
std::vector<std::uint32_t> edges_of(const ArrangementEvents& events, const ListedEvent& event);

/// The event's full row, except for its rank. Exact. Some 10 us.
EventRow listed_row(const ArrangementEvents& events, const ListedEvent& event);

/// Takes out all events that do not meet the condition; ranks stay. Fields as for pair events
/// (pair_event_search.hpp). Exact: bisection finds scales; doubles discard most places.
void keep_events(std::vector<RankedEvent>& list, const ArrangementEvents& events,
                 const EventCondition& condition);

/// The events first to last - 1 as JSON objects, each followed by `end` (write_events.hpp). Exact.
/// Some 10 us an event.
std::string events_as_json(const std::vector<RankedEvent>& list, const ArrangementEvents& events,
                           const std::vector<std::string>& edges, std::size_t first,
                           std::size_t last, std::string_view end);

}  // namespace minkref
