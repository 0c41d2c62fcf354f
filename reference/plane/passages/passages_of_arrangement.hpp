// The tight passages of an existing arrangement of the reduced convolution.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/passages/tight_graph.hpp"
#include "reference/plane/witness.hpp"

namespace minkref::inline plane {

/// Requires P already scaled; segment i of the arrangement belongs to edges[i]. `inside(face)`
/// tells whether a face belongs to the sum. Exact. Triangulates the operands only if some point
/// needs a decision.
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
