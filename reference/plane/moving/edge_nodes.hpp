// Nodes on a convolution edge, and how they move along the edge as the scale grows.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// A point of the arrangement on an edge: another edge's crossing, or an end point of another edge
/// on the same line.
struct EdgeNode {
  enum class Kind : std::uint8_t { crossing, start_of_other, end_of_other };
  static constexpr std::uint32_t always = 0xffffffffU;
  std::uint32_t other = 0;  ///< the other edge
  Kind kind = Kind::crossing;
  /// Moments (later groups of events) at which the node appears and disappears; it exists at both.
  /// `always`: before the first, after the last.
  std::uint32_t from = always, to = always;
};

/// A position along an edge, as a multiple of its direction d from its start: (slope s + value) /
/// den, den > 0. The edge itself spans [0, s] (S-edge) or [0, 1] (T-edge). Linear in the scale
/// since the lines move parallel to themselves (Behar & Lien 2012, Sec. 4.2).
template <class W>
struct PositionAlong {
  W slope = W(0), value = W(0), den = W(1);
};

/// The position of the crossing with b along a. Requires a and b not parallel. As exact as the
/// kernel.
template <class K>
PositionAlong<typename K::Wide> crossing_position(const K& kernel,
                                                  const MovingEdge<typename K::Vector>& a,
                                                  const MovingEdge<typename K::Vector>& b) {
  using W = typename K::Wide;
  const typename K::Vector p(b.p - a.p), q(b.q - a.q);
  PositionAlong<W> result{K::cross(p, b.d), K::cross(q, b.d), K::cross(a.d, b.d)};
  if (kernel.sign(result.den) < 0) {
    return {W(-result.slope), W(-result.value), W(-result.den)};
  }
  return result;
}

/// The position of a vertex on the line of a.
template <class K>
PositionAlong<typename K::Wide> vertex_position(const MovingEdge<typename K::Vector>& a,
                                                const MovingVertex<typename K::Vector>& vertex) {
  const typename K::Vector p(vertex.p - a.p), q(vertex.q - a.q);
  return {K::dot(p, a.d), K::dot(q, a.d), K::dot(a.d, a.d)};
}

/// A node's position along its edge.
template <class K>
PositionAlong<typename K::Wide> node_position(
    const K& kernel, const std::vector<MovingEdge<typename K::Vector>>& edges, std::uint32_t edge,
    const EdgeNode& node) {
  const auto& other = edges[node.other];
  switch (node.kind) {
    case EdgeNode::Kind::crossing:
      return crossing_position(kernel, edges[edge], other);
    case EdgeNode::Kind::start_of_other:
      return vertex_position<K>(edges[edge], start_of(other));
    case EdgeNode::Kind::end_of_other:
      break;
  }
  return vertex_position<K>(edges[edge], end_of(other));
}

/// All edges' nodes, edge by edge.
struct NodeTable {
  std::vector<EdgeNode> nodes;
  std::vector<std::uint32_t> first;  ///< of each edge, and the end

  std::uint32_t begin(std::uint32_t edge) const { return first[edge]; }
  std::uint32_t end(std::uint32_t edge) const { return first[edge + 1]; }
};

}  // namespace minkref::inline plane
