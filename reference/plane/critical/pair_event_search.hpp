// Searches millions of pair events for a condition.
#pragma once

#include "reference/plane/critical/edge_bounds.hpp"
#include "reference/plane/critical/event_condition.hpp"
#include "reference/plane/critical/pair_events.hpp"

namespace minkref::inline plane {

/// Removes from `events.events` all that do not meet the condition; ranks stay as they were among
/// all. Fields: "s", "rank", "x", "y" (the place of `event_places`), "kind" ("pair", "parallel"),
/// "change", and the parents; any other field throws BadInput ("unknown-field"). Exact: bisection
/// finds scales; doubles discard most places. Some 10 ns an event and field, 10 us for a place too
/// near to a bound. `P` and `Q`: the events' operands.
void keep_events(PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                 const EventCondition& condition);

/// Bounds for a pair event's place.
Enclosure place_bounds(const PairEvent& event, const EdgeBounds& bounds, int coordinate);

}  // namespace minkref::inline plane
