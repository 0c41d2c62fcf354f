// The tight passages in an arrangement of the reduced convolution that is there already.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/passages/tight_graph.hpp"
#include "reference/plane/witness.hpp"

namespace minkref::inline plane {

/// P is already scaled; segment i of the arrangement is edges[i]. `inside(face)` tells whether a
/// face lies in the sum. Exact. The operands are triangulated only if there is a point to decide.
template <class Frame, class Inside>
TightGraph tight_graph_of_arrangement(const Frame& frame,
                                      const Arrangement<typename Frame::K>& arrangement,
                                      const std::vector<ConvolutionEdge>& edges,
                                      const PolygonSet& P, const PolygonSet& Q, Inside&& inside) {
  std::optional<Membership> membership;
  return tight_graph(
      frame.kernel, arrangement, edges,
      [&](std::uint32_t n) { return position(frame, arrangement.node(n)); }, inside,
      [&](const Point& x) {
        if (!membership) membership.emplace(P, Q, Rational(1));
        return membership->contact(x) == Contact::touching;
      });
}

}  // namespace minkref::inline plane
