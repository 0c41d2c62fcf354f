// A convolution's arrangement, with the figures that a route reports.
#pragma once

#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/convolution/convolution_segments.hpp"
#include "reference/plane/kernel/kernel.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

template <class K>
struct ConvolutionArrangement {
  ConvolutionSegments<K> convolution;
  Arrangement<K> arrangement;
};

template <class K>
ConvolutionArrangement<K> convolution_arrangement(const K& kernel,
                                                  const Operand<typename K::Vector>& P,
                                                  const Operand<typename K::Vector>& Q, bool full,
                                                  Statistics& statistics) {
  auto convolution = convolution_segments<K>(convolution_edges(kernel, P, Q, full), P, Q);
  Arrangement<K> arrangement(kernel, convolution.vertices, convolution.segments);
  for (const ConvolutionEdge& edge : convolution.edges) {
    ++(edge.kind == ConvolutionEdge::Kind::S ? statistics.s_edges : statistics.t_edges);
  }
  statistics.nodes = arrangement.node_count();
  statistics.faces = arrangement.face_count();
  return {std::move(convolution), std::move(arrangement)};
}

inline void add_counts(Statistics& statistics, const SignCounts& counts) {
  statistics.by_float += counts.by_float;
  statistics.by_integer += counts.by_integer;
  statistics.by_rational += counts.by_rational;
}

/// Whether an operand is a single polygon (or a point, or a segment): its closed set is connected.
inline bool connected(const PolygonSet& set) { return set.polygons.size() <= 1; }

}  // namespace minkref::inline plane
