// The convolution and the reduced convolution of two polygon sets (Behar & Lien 2012, Sec. 3).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// A convolution edge with its parents: an S-edge has an edge of P and a vertex of Q, a T-edge an
/// edge of Q and a vertex of P. The start vertex names an edge.
struct ConvolutionEdge {
  enum class Kind : std::uint8_t { S, T } kind = Kind::S;
  std::int8_t sign = 1;   ///< -1 at reflex vertices (full convolution only)
  VertexId edge, vertex;  ///< S: edge of P, vertex of Q; T: edge of Q, vertex of P
  friend bool operator==(const ConvolutionEdge&, const ConvolutionEdge&) = default;
};

/// Reduced convolution: an edge d pairs with a strictly convex vertex (directions in, out) iff the
/// ccw turn contains d, [in, out) at vertices of Q, (in, out] at vertices of P
/// (docs/definitions.md, "Compatibility"). The scale does not change its size. Exact.
std::vector<ConvolutionEdge> reduced_convolution(const PolygonSet& P, const PolygonSet& Q);

/// Full convolution: reflex vertices contribute with sign -1. A closed signed cycle. Exact.
std::vector<ConvolutionEdge> full_convolution(const PolygonSet& P, const PolygonSet& Q);

/// An edge's end points at scale s. Exact.
struct Segment {
  Point start, end;
};
Segment at_scale(const ConvolutionEdge& edge, const PolygonSet& P, const PolygonSet& Q,
                 const Rational& scale);

}  // namespace minkref::inline plane
