// Scales at which three convolution edges pass through a common point.
#pragma once

#include <vector>

#include "reference/plane/critical/moments.hpp"
#include "reference/plane/moving/edge_nodes.hpp"

namespace minkref::inline plane {

/// Edges a < b < c share a point at one scale, where two of them swap along the third: both meet
/// the third at all scales nearby, and change their order at the event. The paper's Section 4.2 has
/// no such events (docs/definitions.md, "Kinds of critical scale").
struct TripleEvent {
  double approximate = 0;  ///< the scale, with a relative error of at most 2^-50
  std::uint32_t a = 0, b = 0, c = 0;
  /// Two swapping nodes of one edge: the event's exact definition.
  std::uint32_t edge = 0, first = 0, second = 0;
  std::uint8_t swaps = 0;  ///< bits 0, 1, 2: nodes swap along a, b, c
};

/// All triple events within the open window (0 and infinity for missing bounds), unordered. Exact:
/// doubles discard pairs of nodes, integers or rationals decide. O(sum of k^2) over the numbers k
/// of nodes that an edge ever has; memory O(N + events).
std::vector<TripleEvent> triple_events(const PolygonSet& P, const PolygonSet& Q,
                                       const std::vector<ConvolutionEdge>& edges,
                                       const NodeTable& table, const Moments& moments,
                                       const ScaleWindow& window);

/// The exact scale of a triple event. Some 5 us.
Rational triple_scale(const TripleEvent& event, const std::vector<RationalEdge>& edges,
                      const NodeTable& table);

}  // namespace minkref::inline plane
