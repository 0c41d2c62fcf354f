#include "reference/plane/index/piece_track.hpp"

#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {
namespace {

Track track_of(const MovingVertex<Vector2<Rational>>& vertex) {
  return {{vertex.q.x(), vertex.q.y()}, {vertex.p.x(), vertex.p.y()}};
}

}  // namespace

Track track_of(const SweptBoundary& boundary, std::uint32_t edge, const NodeName& node) {
  const RationalEdge &own = boundary.moving[edge], &other = boundary.moving[node.other];
  switch (node.kind) {
    case NodeName::Kind::own_start:
      return track_of(start_of(own));
    case NodeName::Kind::own_end:
      return track_of(end_of(own));
    case NodeName::Kind::start_of_other:
      return track_of(start_of(other));
    case NodeName::Kind::end_of_other:
      return track_of(end_of(other));
    case NodeName::Kind::crossing:
      break;
  }
  return track_along(own, crossing_position(PlainKernel<Rational>{}, own, other));
}

}  // namespace minkref::inline plane
