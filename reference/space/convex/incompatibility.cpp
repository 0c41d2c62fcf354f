#include "reference/space/convex/incompatibility.hpp"

#include <vector>

#include "reference/number/float_environment.hpp"

namespace minkref::inline space {
namespace {

using RationalVector = std::array<Rational, 3>;

/// Normal to the facet of S P.
RationalVector normal_of(const ConvexPolyhedron& P, std::uint32_t facet, const Scaling& scaling) {
  const IntegerVector& n = P.normal(facet);
  return {n[0] / scaling[0], n[1] / scaling[1], n[2] / scaling[2]};
}

/// The normal times the half-edge: positive for a rising half-edge.
Rational rise(const RationalVector& normal, const ConvexPolyhedron& Q, std::uint32_t half_edge) {
  const IntegerVector d = Q.vector(half_edge);
  return (normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2]) / Q.denominator();
}

}  // namespace

Incompatibility incompatibility(const ConvexPolyhedron& P, std::uint32_t facet,
                                const ConvexPolyhedron& Q, std::uint32_t vertex,
                                const Scaling& scaling, Form form) {
  const FloatEnvironment standard;
  require_positive(scaling);
  const RationalVector normal = normal_of(P, facet, scaling);
  std::optional<Rational> most;
  std::uint32_t witness = 0;
  for (std::uint32_t h = Q.first(vertex); h < Q.first(vertex + 1); ++h) {
    Rational height = rise(normal, Q, h);
    if (form == Form::printed) height = abs(height);
    if (most && height <= *most) continue;
    most = height;
    witness = h;
  }
  if (*most < 0) most = 0;
  const Rational squared_length =
      normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  return {*most * *most / squared_length, witness};
}

std::optional<std::uint32_t> descend(const ConvexPolyhedron& P, std::uint32_t facet,
                                     const ConvexPolyhedron& Q, std::uint32_t vertex,
                                     const Scaling& scaling, Form form) {
  const FloatEnvironment standard;
  std::vector<bool> met(Q.vertices());
  while (!met[vertex]) {
    met[vertex] = true;
    if (incompatibility(P, facet, Q, vertex, scaling, Form::corrected).squared_degree == 0) {
      return vertex;
    }
    vertex = Q.target(incompatibility(P, facet, Q, vertex, scaling, form).witness);
  }
  return std::nullopt;
}

}  // namespace minkref::inline space
