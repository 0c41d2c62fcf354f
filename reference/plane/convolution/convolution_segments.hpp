// A convolution's edges at one scale, as segments between shared vertices.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/segment_contacts.hpp"
#include "reference/plane/convolution/convolution_rule.hpp"

namespace minkref::inline plane {

/// Segment i belongs to edges[i]; all edges that end at p + q share this vertex.
template <class K>
struct ConvolutionSegments {
  std::vector<ConvolutionEdge> edges;
  std::vector<typename K::Vector> vertices;
  std::vector<IndexedSegment> segments;
  std::vector<std::pair<VertexId, VertexId>> parents;  ///< of each vertex: of P, of Q
};

/// Requires P already scaled. As exact as the kernel's addition. O(N).
template <class K>
ConvolutionSegments<K> convolution_segments(std::vector<ConvolutionEdge> edges,
                                            const Operand<typename K::Vector>& P,
                                            const Operand<typename K::Vector>& Q) {
  const auto offsets = [](const Operand<typename K::Vector>& operand) {
    std::vector<std::uint64_t> first{0};
    for (const auto& ring : operand.rings) first.push_back(first.back() + ring.size());
    return first;
  };
  const auto first_p = offsets(P), first_q = offsets(Q);
  ConvolutionSegments<K> result;
  std::unordered_map<std::uint64_t, std::uint32_t> known;
  known.reserve(2 * edges.size());
  const auto vertex = [&](VertexId p, VertexId q) {
    const std::uint64_t key =
        (first_p[p.ring] + p.index) * first_q.back() + first_q[q.ring] + q.index;
    const auto [place, fresh] =
        known.try_emplace(key, static_cast<std::uint32_t>(result.vertices.size()));
    if (fresh) {
      result.vertices.push_back(
          typename K::Vector(P.rings[p.ring][p.index] + Q.rings[q.ring][q.index]));
      result.parents.emplace_back(p, q);
    }
    return place->second;
  };
  const auto following = [](const Operand<typename K::Vector>& operand, VertexId v) {
    const auto size = static_cast<std::uint32_t>(operand.rings[v.ring].size());
    return VertexId{v.ring, (v.index + 1) % size};
  };
  result.segments.reserve(edges.size());
  for (const ConvolutionEdge& e : edges) {
    look_for_interrupt();
    if (e.kind == ConvolutionEdge::Kind::S) {
      result.segments.push_back({vertex(e.edge, e.vertex), vertex(following(P, e.edge), e.vertex)});
    } else {
      result.segments.push_back({vertex(e.vertex, e.edge), vertex(e.vertex, following(Q, e.edge))});
    }
  }
  result.edges = std::move(edges);
  return result;
}

}  // namespace minkref::inline plane
