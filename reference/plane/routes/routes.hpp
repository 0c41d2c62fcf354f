// The three routes to the sum, each a separate translation unit. Requires P already scaled.
#pragma once

#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// Reduced convolution and collision detection, exact. Finds the tight passages from the same
/// arrangement, if asked for.
BoundaryGraph paper_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics,
                          std::vector<TightPassage>* passages = nullptr);

/// A boundary, and the convolution edge below each of its edges.
struct BoundaryOnConvolution {
  BoundaryGraph graph;
  std::vector<std::uint32_t> below;          ///< for each edge of the graph, among `convolution`
  std::vector<ConvolutionEdge> convolution;  ///< reduced, in its order
};

/// As paper_route.
BoundaryOnConvolution paper_route_on_convolution(const PolygonSet& P, const PolygonSet& Q,
                                                 Statistics& statistics);

/// The paper's route with another arithmetic: "interval" (certified, or UndecidedSign), "double",
/// "mpfr:BITS". The scale enters the computation itself. Returns this arithmetic's answer, brought
/// exactly to canonical form.
Canonical paper_route_in(const std::string& arithmetic, const PolygonSet& P, const PolygonSet& Q,
                         const Rational& scale, Statistics& statistics);

/// Full signed convolution of operands cut to be simply connected, exact.
BoundaryGraph winding_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics);

/// Union of all sums of pairs of triangles, exact.
BoundaryGraph definition_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics);

}  // namespace minkref::inline plane
