#include "reference/convex/convex_sum.hpp"

#include <unordered_map>

#include "reference/convex/pieces.hpp"
#include "reference/convex/sum_coordinates.hpp"

namespace minkref {
namespace {

using Pair = SumVertices::Pair;

/// The facets of all compatible pairs.
class PiecesOfPairs {
 public:
  PiecesOfPairs(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                const Compatibility& compatibility)
      : P_(P), Q_(Q) {
    const SumVertices vertices(P, Q, compatibility);
    pieces_.pairs = vertices.pairs();
    for (std::uint32_t k = 0; k < pieces_.pairs.size(); ++k) {
      numbers_.emplace(key(pieces_.pairs[k]), k);
    }
    HomogeneousPoints points;
    sum_coordinates(P, Q, scaling, vertices, points);
    pieces_.denominators = points.denominators;
    for (std::size_t k = 0; k < pieces_.pairs.size(); ++k) {
      pieces_.points.push_back(
          {numerator_at(points, k, 0), numerator_at(points, k, 1), numerator_at(points, k, 2)});
    }
    add_facets(compatibility);
  }

  const Pieces& pieces() const { return pieces_; }

 private:
  static std::uint64_t key(Pair pair) { return std::uint64_t{pair.p} << 32 | pair.q; }
  std::uint32_t number(std::uint32_t p, std::uint32_t q) const { return numbers_.at(key({p, q})); }

  void add_facets(const Compatibility& compatibility) {
    for (std::uint32_t f = 0; f < P_.facets(); ++f) {
      Face ring;
      for_vertices_of(
          P_, f, [&](std::uint32_t p) { ring.push_back(number(p, compatibility.vertex_of_Q[f])); });
      pieces_.add(std::move(ring));
    }
    for (std::uint32_t g = 0; g < Q_.facets(); ++g) {
      Face ring;
      for_vertices_of(
          Q_, g, [&](std::uint32_t q) { ring.push_back(number(compatibility.vertex_of_P[g], q)); });
      pieces_.add(std::move(ring));
    }
    for (std::uint32_t e = 0; e < P_.edges(); ++e) {
      const std::uint32_t a = P_.origin(P_.half_edge(e)), b = P_.target(P_.half_edge(e));
      for (const std::uint32_t d : compatibility.chains[e]) {
        const std::uint32_t q = Q_.origin(d), r = Q_.target(d);
        pieces_.add({number(a, q), number(a, r), number(b, r), number(b, q)});
      }
    }
  }

  const ConvexPolyhedron& P_;
  const ConvexPolyhedron& Q_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  Pieces pieces_;
};

}  // namespace

ConvexSum surface_of(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& scaling,
                     const Compatibility& compatibility) {
  return united(PiecesOfPairs(P, Q, scaling, compatibility).pieces());
}

ConvexSum surface_of(const DynamicConvexSum& sum) {
  return surface_of(sum.P(), sum.Q(), sum.scaling(), sum.compatibility());
}

}  // namespace minkref
