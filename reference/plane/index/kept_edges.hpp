// Convolution edges far from a change of operands, whose part of a swept boundary stays.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/critical/moving_pairs.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// Two operands, with edges of their convolution.
struct Convolved {
  const PolygonSet& P;
  const PolygonSet& Q;
  const std::vector<ConvolutionEdge>& edges;
};

struct KeptEdges {
  std::vector<std::uint32_t> before;  ///< the old number of each new edge; no_entry: not kept
  std::vector<std::uint32_t> after;   ///< the new number of each old edge, kept or not, if not gone
  std::size_t count = 0;
};

/// Edges with the same patch as before, far from the change. Let D be the place where P differs:
/// the sums can differ only within sD + Q, and edges new or gone lie there too; with Q changed, the
/// same for sP + D. Boxes cover D, a box for each group of changed edges joined to each other. A
/// patch certainly outside all boxes' sums, at all scales of the window, stays: new edges cannot
/// meet it, and each point is inside or outside as before.
///
/// Rings may come in another order, or begin at another vertex. No edge stays if an operand without
/// area changes, or if the window has no lower bound (all patches meet at scale 0). Exact
/// comparison, doubles with a bound for boxes. O(N c) for N edges and c boxes, at most 16.
KeptEdges kept_edges(const Convolved& before, const Convolved& now,
                     const std::vector<RationalEdge>& moving, const ScaleWindow& window);

/// Leaves out holes and components too far away to matter to any point on the given edges' patches:
/// questions about such points have the same answers. O(n + N).
std::pair<PolygonSet, PolygonSet> parts_near(const PolygonSet& P, const PolygonSet& Q,
                                             const std::vector<RationalEdge>& moving,
                                             const std::vector<std::uint32_t>& which,
                                             const ScaleWindow& window);

}  // namespace minkref::inline plane
