// Those of millions of pair events that meet a condition.
#pragma once

#include "reference/plane/critical/edge_bounds.hpp"
#include "reference/plane/critical/event_condition.hpp"
#include "reference/plane/critical/pair_events.hpp"

namespace minkref::inline plane {

/// Takes out of `events.events` all that do not meet the condition; ranks stay as they were among
/// all. Fields: "s", "rank", "x", "y" (the place of `event_places`), "kind" ("pair", "parallel"),
/// "change", and the parents; another one throws BadInput ("unknown-field"). Exact: scales are
/// found by bisection, of places doubles discard most. Some 10 ns an event and field, 10 us where a
/// place is too near to a bound. `P` and `Q`: the operands of the events.
void keep_events(PairEvents& events, const PolygonSet& P, const PolygonSet& Q,
                 const EventCondition& condition);

/// Where a pair event may be.
Enclosure place_bounds(const PairEvent& event, const EdgeBounds& bounds, int coordinate);

}  // namespace minkref::inline plane
