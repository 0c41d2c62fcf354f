#include "reference/plane/dynamic/triple_events.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

Rational triple_scale(const TripleEvent& event, const std::vector<RationalEdge>& edges,
                      const NodeTable& table) {
  const PlainKernel<Rational> kernel;
  const auto f = node_position(kernel, edges, event.edge, table.nodes[event.first]);
  const auto g = node_position(kernel, edges, event.edge, table.nodes[event.second]);
  return Rational((g.value * f.den - f.value * g.den) / (f.slope * g.den - g.slope * f.den));
}

}  // namespace minkref::inline plane
