#include "reference/plane/convolution/convolution.hpp"

#include "reference/number/float_environment.hpp"
#include "reference/plane/convolution/between.hpp"
#include "reference/plane/convolution/convolution_rule.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref::inline plane {
namespace {

const Point& vertex(const PolygonSet& set, VertexId id, std::uint32_t step) {
  std::uint32_t ring = 0;
  for (const Polygon& polygon : set.polygons) {
    if (id.ring < ring + 1 + polygon.holes.size()) {
      const Ring& vertices = id.ring == ring ? polygon.outer : polygon.holes[id.ring - ring - 1];
      return vertices[(id.index + step) % vertices.size()];
    }
    ring += static_cast<std::uint32_t>(1 + polygon.holes.size());
  }
  throw std::out_of_range("VertexId: no such ring");
}

}  // namespace

std::vector<ConvolutionEdge> convolution(const PolygonSet& P, const PolygonSet& Q, bool full,
                                         Between between) {
  return on_exact_frame(P, Q, [&](const auto& frame) {
    return convolution_edges(frame.kernel, frame.P, frame.Q, full, between);
  });
}

std::vector<ConvolutionEdge> reduced_convolution(const PolygonSet& P, const PolygonSet& Q) {
  const FloatEnvironment standard;
  return convolution(P, Q, false, Between::half_open);
}

std::vector<ConvolutionEdge> full_convolution(const PolygonSet& P, const PolygonSet& Q) {
  const FloatEnvironment standard;
  return convolution(P, Q, true, Between::half_open);
}

Segment at_scale(const ConvolutionEdge& edge, const PolygonSet& P, const PolygonSet& Q,
                 const Rational& scale) {
  const bool s_edge = edge.kind == ConvolutionEdge::Kind::S;
  const auto end = [&](std::uint32_t step) -> Point {
    const Point& p = s_edge ? vertex(P, edge.edge, step) : vertex(P, edge.vertex, 0);
    const Point& q = s_edge ? vertex(Q, edge.vertex, 0) : vertex(Q, edge.edge, step);
    return {scale * p.x + q.x, scale * p.y + q.y};
  };
  return {end(0), end(1)};
}

}  // namespace minkref::inline plane
