// Names of P's edges as given, by ring and first vertex.
#pragma once

#include <cstdint>

#include "reference/disc/diagram/diagram_events.hpp"

namespace minkref::inline disc {

/// The side to look at from a point on an edge: at a vertex, the edge that ends there, or the edge
/// that goes on.
enum class Past : std::uint8_t { ends, goes_on };

/// Returns the name of P's edge under an event's foot on one of the event's lines. A line may have
/// many edges, and an edge of the curves goes on through straight vertices of P: the name belongs
/// to the part under the foot. `edge` comes from DiagramEvent::edges, or is another edge of the
/// curves with the event in front. Exact. O(k + log n) for k straight vertices on the edge.
VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const DiagramEvent& event,
                   Past past = Past::ends);
/// Returns the same for a vertex on the edge, in the frame of the curves.
VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const Point& vertex,
                   Past past = Past::ends);
/// Returns the same for a foot on the edge, in the frame of the curves.
VertexId edge_name(const DiagramEvents& diagram, std::uint32_t edge, const RootPoint& foot,
                   Past past = Past::ends);

}  // namespace minkref::inline disc
