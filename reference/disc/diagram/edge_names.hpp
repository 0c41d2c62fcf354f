// Names of edges: those of P as it was given, by ring and first vertex.
#pragma once

#include <cstdint>

#include "reference/disc/diagram/diagram_events.hpp"

namespace minkref::inline disc {

/// The side on which an edge is looked at from a point of it: where the point is a vertex, the edge
/// that ends there, or the one that goes on.
enum class Past : std::uint8_t { ends, goes_on };

/// Returns the name of the edge of P that the foot of an event on one of its lines is on. A line
/// may have many edges, and an edge of the curves goes on through straight vertices of P: the name
/// is that of the part which the foot is on. `edge` is one of DiagramEvent::edges, or another edge
/// of the curves in front of which the event is. Exact. O(k + log n) for k straight vertices on it.
VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const DiagramEvent& event,
                   Past past = Past::ends);
/// Returns the same for a vertex on the edge, in the frame of the curves.
VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const Point& vertex,
                   Past past = Past::ends);

}  // namespace minkref::inline disc
