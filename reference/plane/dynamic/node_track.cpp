#include "reference/plane/dynamic/node_track.hpp"

#include "reference/plane/dynamic/edge_history.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

Track node_track(const ArrangementEvents& events, std::uint32_t edge, std::uint32_t node) {
  const RationalEdge& e = events.moving()[edge];
  PositionAlong<Rational> position;
  if (node == end_of_edge) {
    (e.is_s() ? position.slope : position.value) = 1;
  } else if (node != start_of_edge) {
    const EdgeNode& n = events.table().nodes[node];
    // For edges on a common line at one scale only: the end point itself, not its projection.
    if (n.kind == EdgeNode::Kind::start_of_other) return node_track(events, n.other, start_of_edge);
    if (n.kind == EdgeNode::Kind::end_of_other) return node_track(events, n.other, end_of_edge);
    position = node_position(PlainKernel<Rational>{}, events.moving(), edge, n);
  }
  return track_along(e, position);
}

}  // namespace minkref::inline plane
