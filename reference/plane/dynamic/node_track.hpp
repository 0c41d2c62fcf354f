// Where a node is, as a function of the scale.
#pragma once

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/dynamic/edge_nodes.hpp"

namespace minkref {

/// A point a + s b.
struct Track {
  Point a, b;
  Point at(const Rational& scale) const {
    return {Rational(a.x + scale * b.x), Rational(a.y + scale * b.y)};
  }
};

/// Of a position along an edge. Exact.
Track track_along(const RationalEdge& edge, const PositionAlong<Rational>& position);

/// The point of a node of an edge; start_of_edge and end_of_edge (edge_history.hpp) name the edge's
/// own ends. Exact. Some 5 us.
Track node_track(const ArrangementEvents& events, std::uint32_t edge, std::uint32_t node);

}  // namespace minkref
