#include "reference/space/convex/segment_sum.hpp"

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/convex/pieces.hpp"

namespace minkref::inline space {
namespace {

/// P's vertex v at the segment's end k is the point 2 v + k.
std::uint32_t number(std::uint32_t vertex, bool at_b) { return 2 * vertex + (at_b ? 1U : 0U); }

/// For each facet whether the segment rises above it.
std::vector<bool> rising(const ConvexPolyhedron& P, const Scaling& scaling, const SpacePoint& a,
                         const SpacePoint& b) {
  const SpacePoint d{(b.x - a.x) / scaling[0], (b.y - a.y) / scaling[1], (b.z - a.z) / scaling[2]};
  std::vector<bool> result;
  for (std::uint32_t f = 0; f < P.facets(); ++f) {
    const IntegerVector& n = P.normal(f);
    result.push_back(n[0] * d.x + n[1] * d.y + n[2] * d.z > 0);
  }
  return result;
}

}  // namespace

ConvexSum sum_with_segment(const ConvexPolyhedron& P, const Scaling& scaling, const SpacePoint& a,
                           const SpacePoint& b) {
  const FloatEnvironment standard;
  require_positive(scaling);
  if (a == b) {
    throw BadInput("zero-length-edge", "the two ends of the segment are equal",
                   "give a point by one vertex");
  }
  Pieces<IntegerVector> pieces;
  std::vector<SpacePoint> points;
  const Polyhedron body = scaled(P.surface(), scaling);
  for (std::uint32_t v = 0; v < P.vertices(); ++v) {
    const SpacePoint& p = body.vertices[v];
    points.push_back({p.x + a.x, p.y + a.y, p.z + a.z});
    points.push_back({p.x + b.x, p.y + b.y, p.z + b.z});
    pieces.pairs.push_back({v, 0});
    pieces.pairs.push_back({v, 1});
  }
  IntegerPoints integers = integer_points(points);
  pieces.points = std::move(integers.points);
  pieces.denominators = {integers.denominator, integers.denominator, integers.denominator};
  const std::vector<bool> at_b = rising(P, scaling, a, b);
  for (std::uint32_t f = 0; f < P.facets(); ++f) {
    Face ring;
    for_vertices_of(P, f, [&](std::uint32_t v) { ring.push_back(number(v, at_b[f])); });
    pieces.add(std::move(ring));
  }
  for (std::uint32_t h = 0; h < P.half_edges(); ++h) {
    if (!at_b[P.left(h)] || at_b[P.right(h)]) continue;
    const std::uint32_t v = P.origin(h), w = P.target(h);
    pieces.add({number(v, true), number(v, false), number(w, false), number(w, true)});
  }
  return united(pieces);
}

}  // namespace minkref::inline space
