// Exact scales and places of events.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

struct EventPlace {
  Rational scale;
  Point at;                 ///< where the edges meet at that scale
  std::optional<Point> to;  ///< parallel edges that share a segment there: its other end
};

/// The places of the events first to last - 1. Exact. Some 10 us an event.
std::vector<EventPlace> event_places(const PairEvents& events, std::size_t first, std::size_t last,
                                     const PolygonSet& P, const PolygonSet& Q);
/// The places as above; `edges` must be the edges of `events`, over rationals.
std::vector<EventPlace> event_places(const PairEvents& events, std::size_t first, std::size_t last,
                                     const std::vector<RationalEdge>& edges);

}  // namespace minkref::inline plane
