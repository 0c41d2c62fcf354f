// Convolution edges as functions of the scale (Behar & Lien 2012, Sec. 4.1).
#pragma once

#include <vector>

#include "reference/interrupt.hpp"
#include "reference/number/eigen.hpp"
#include "reference/number/rational.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/kernel/operand.hpp"

namespace minkref::inline plane {

/// An S-edge s e_P + v_Q grows and moves with s, a T-edge e_Q + s v_P only moves. Both start at
/// s p + q.
template <class V>
struct MovingEdge {
  ConvolutionEdge::Kind kind = ConvolutionEdge::Kind::S;
  V p, q;
  V d;  ///< direction of the parent edge: end - start is s d for an S-edge, d for a T-edge

  bool is_s() const { return kind == ConvolutionEdge::Kind::S; }
};

/// An end point of an edge, s p + q.
template <class V>
struct MovingVertex {
  V p, q;
};

template <class V>
MovingVertex<V> start_of(const MovingEdge<V>& edge) {
  return {edge.p, edge.q};
}

template <class V>
MovingVertex<V> end_of(const MovingEdge<V>& edge) {
  return edge.is_s() ? MovingVertex<V>{V(edge.p + edge.d), edge.q}
                     : MovingVertex<V>{edge.p, V(edge.q + edge.d)};
}

template <class T, class V>
V at(const MovingVertex<V>& vertex, const T& scale) {
  return V(T(scale * vertex.p.x()) + vertex.q.x(), T(scale * vertex.p.y()) + vertex.q.y());
}

/// A convolution's edges for unscaled P and Q. As exact as V's subtraction.
template <class V>
std::vector<MovingEdge<V>> moving_edges(const std::vector<ConvolutionEdge>& edges,
                                        const Operand<V>& P, const Operand<V>& Q) {
  const auto vertex = [](const Operand<V>& operand, VertexId id) -> const V& {
    return operand.rings[id.ring][id.index];
  };
  const auto direction = [](const Operand<V>& operand, VertexId id) {
    const auto& ring = operand.rings[id.ring];
    return V(ring[(id.index + 1) % ring.size()] - ring[id.index]);
  };
  std::vector<MovingEdge<V>> result;
  result.reserve(edges.size());
  for (const ConvolutionEdge& e : edges) {
    look_for_interrupt();
    if (e.kind == ConvolutionEdge::Kind::S) {
      result.push_back({e.kind, vertex(P, e.edge), vertex(Q, e.vertex), direction(P, e.edge)});
    } else {
      result.push_back({e.kind, vertex(P, e.vertex), vertex(Q, e.edge), direction(Q, e.edge)});
    }
  }
  return result;
}

using RationalEdge = MovingEdge<Vector2<Rational>>;

}  // namespace minkref::inline plane
