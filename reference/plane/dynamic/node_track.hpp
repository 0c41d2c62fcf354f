// A node's position as a function of the scale.
#pragma once

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/moving/track.hpp"

namespace minkref::inline plane {

/// The track of an edge's node; start_of_edge and end_of_edge (edge_history.hpp) name the edge's
/// own ends. Exact. Some 5 us.
Track node_track(const ArrangementEvents& events, std::uint32_t edge, std::uint32_t node);

}  // namespace minkref::inline plane
