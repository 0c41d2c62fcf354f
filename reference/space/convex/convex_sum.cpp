#include "reference/space/convex/convex_sum.hpp"

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "reference/space/convex/pieces.hpp"
#include "reference/space/convex/sum_coordinates.hpp"
#include "reference/space/convex/word_surface.hpp"

namespace minkref::inline space {
namespace {

using Pair = SumVertices::Pair;

/// Numbers all pairs.
class PairNumbers {
 public:
  PairNumbers(const ConvexPolyhedron& P, const std::vector<Pair>& pairs)
      : first_(P.vertices() + 1), at_P_(pairs.size()) {
    for (const Pair& pair : pairs) ++first_[pair.p + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::uint32_t> next = first_;
    for (std::uint32_t k = 0; k < pairs.size(); ++k) at_P_[next[pairs[k].p]++] = {pairs[k].q, k};
  }

  /// A vertex of P has few partners among Q's vertices.
  std::uint32_t operator()(std::uint32_t p, std::uint32_t q) const {
    std::uint32_t k = first_[p];
    while (at_P_[k].q != q) ++k;
    return at_P_[k].number;
  }

 private:
  struct Numbered {
    std::uint32_t q, number;
  };
  std::vector<std::uint32_t> first_;
  std::vector<Numbered> at_P_;  // first_[p] .. first_[p + 1] - 1 belong to p
};

/// Unites the facets from all compatible pairs.
template <class Point>
ConvexSum united_pairs(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                       const Compatibility& compatibility, const SumVertices& vertices,
                       const IntegerVector& denominators, std::vector<Point> points) {
  Pieces<Point> pieces;
  pieces.pairs = vertices.pairs();
  pieces.points = std::move(points);
  pieces.denominators = denominators;
  const PairNumbers number(P, pieces.pairs);
  for (std::uint32_t f = 0; f < P.facets(); ++f) {
    Face ring;
    for_vertices_of(
        P, f, [&](std::uint32_t p) { ring.push_back(number(p, compatibility.vertex_of_Q[f])); });
    pieces.add(std::move(ring));
  }
  for (std::uint32_t g = 0; g < Q.facets(); ++g) {
    Face ring;
    for_vertices_of(
        Q, g, [&](std::uint32_t q) { ring.push_back(number(compatibility.vertex_of_P[g], q)); });
    pieces.add(std::move(ring));
  }
  for (std::uint32_t e = 0; e < P.edges(); ++e) {
    const std::uint32_t a = P.origin(P.half_edge(e)), b = P.target(P.half_edge(e));
    for (const std::uint32_t d : compatibility.chains[e]) {
      const std::uint32_t q = Q.origin(d), r = Q.target(d);
      pieces.add({number(a, q), number(a, r), number(b, r), number(b, q)});
    }
  }
  return united(pieces);
}

ConvexSum surface_of(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const Compatibility& compatibility, const SumVertices& vertices) {
  HomogeneousPoints points;
  sum_coordinates(P, Q, scaling, vertices, points);
  const auto united_as = [&](auto rows) {
    return united_pairs(P, Q, compatibility, vertices, points.denominators, std::move(rows));
  };
  if (P.most_corners() + Q.most_corners() <= most_word_corners) {
    if (auto words = in_words(points)) return united_as(std::move(*words));
  }
  return united_as(in_integers(points));
}

}  // namespace

ConvexSum surface_of(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const Compatibility& compatibility) {
  return surface_of(P, Q, scaling, compatibility, SumVertices(P, Q, compatibility));
}

ConvexSum surface_of(const DynamicConvexSum& sum) {
  WordSurface surface;
  if (surface.renew(sum)) return surface.sum();
  return surface_of(sum.P(), sum.Q(), sum.scaling(), sum.compatibility(), sum.vertices());
}

}  // namespace minkref::inline space
