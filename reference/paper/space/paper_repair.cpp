#include "reference/paper/space/paper_repair.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"
#include "reference/number/exact_value.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/paper/space/normals_and_edges.hpp"
#include "reference/plane/kernel/arithmetic_name.hpp"
#include "reference/space/convex/index_set.hpp"
#include "reference/space/convex/static_convex_sum.hpp"

namespace minkref::inline space {
namespace {

Rational exactly(const Rational& number) { return number; }
Rational exactly(const Interval& number) { return exact_value(approximate(number)); }
template <class T>
Rational exactly(const T& number) {
  return exact_value(number);
}

Compatibility at_first(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& at) {
  Contacts contacts(P, Q);
  contacts.rescale(at);
  return by_traversal(contacts);
}

template <class T>
class RepairIn : public PaperRepair {
 public:
  RepairIn(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& first,
           const Arithmetic<T>& arithmetic, const RepairReadings& readings)
      : arithmetic_(arithmetic),
        readings_(readings),
        P_(P),
        Q_(Q),
        scaling_(first),
        state_(at_first(P, Q, first)),
        across_P_(P, Q, true, arithmetic, readings),
        across_Q_(Q, P, false, arithmetic, readings) {}

  RepairReport update(const Scaling& to) override {
    const FloatEnvironment standard;
    require_positive(to);
    scaling_ = to;
    const Vector3<T> factors{arithmetic_(to[0]), arithmetic_(to[1]), arithmetic_(to[2])};
    across_P_.rescale(factors);
    across_Q_.rescale(factors);
    RepairReport report;
    find_crossings();
    IndexSet suspects(P_.edges());
    mend_facets_of_P(report, suspects);
    if (readings_.errors != RepairReadings::Errors::facets_of_P) {
      mend_facets_of_Q(report, suspects);
    }
    mend_chains(report, suspects);
    return report;
  }

  const Compatibility& compatibility() const override { return state_; }
  const Scaling& scaling() const override { return scaling_; }

  std::vector<SpacePoint> coordinates(const std::vector<SumVertices::Pair>& pairs) const override {
    const FloatEnvironment standard;
    std::vector<SpacePoint> points;
    points.reserve(pairs.size());
    for (const auto& [p, q] : pairs) {
      std::array<Rational, 3> at;
      for (std::size_t i = 0; i < 3; ++i) {
        const T scaled =
            arithmetic_(scaling_[i]) * arithmetic_(Rational(P_.point(p)[i], P_.denominator()));
        at[i] = exactly(T(scaled + arithmetic_(Rational(Q_.point(q)[i], Q_.denominator()))));
      }
      points.push_back({at[0], at[1], at[2]});
    }
    return points;
  }

 private:
  using Chain = std::vector<std::uint32_t>;

  /// Lists, for each edge of Q, the edges of P paired with the edge before the repair.
  void find_crossings() {
    crossing_.assign(Q_.edges(), {});
    for (std::uint32_t e = 0; e < P_.edges(); ++e) {
      for (const std::uint32_t d : state_.chains[e]) crossing_[Q_.edge(d)].push_back(e);
    }
  }

  /// Tests a facet (all facets are tested); nothing if the vertex is compatible.
  std::optional<FacetError> test(const NormalsAndEdges<T>& across, std::uint32_t facet,
                                 std::uint32_t vertex) const {
    Fan<T> fan = across.look(facet, vertex);
    if (fan.compatible) return std::nullopt;
    FacetError error;
    error.of_P = across.of_P();
    error.facet = facet;
    error.vertex = vertex;
    std::vector<bool> met(across.body().vertices());
    for (; !fan.compatible; fan = across.look(facet, vertex)) {
      look_for_interrupt();
      if (met[vertex]) return error;  // the same edges again and again
      met[vertex] = true;
      const std::uint32_t next = across.body().target(fan.witness);
      error.steps.push_back({vertex, next, exactly(across.squared_degree(facet, fan.degree))});
      vertex = next;
    }
    error.end = vertex;
    return error;
  }

  void mend_facets_of_P(RepairReport& report, IndexSet& suspects) {
    for (std::uint32_t f = 0; f < P_.facets(); ++f) {
      auto error = test(across_P_, f, state_.vertex_of_Q[f]);
      if (!error) continue;
      if (error->end) state_.vertex_of_Q[f] = *error->end;
      const std::uint32_t start = P_.start(f);
      std::uint32_t h = start;
      do suspects.insert(P_.edge(h));
      while ((h = P_.next(h)) != start);
      report.errors.push_back(std::move(*error));
    }
  }

  void mend_facets_of_Q(RepairReport& report, IndexSet& suspects) {
    for (std::uint32_t g = 0; g < Q_.facets(); ++g) {
      auto error = test(across_Q_, g, state_.vertex_of_P[g]);
      if (!error) continue;
      if (error->end) state_.vertex_of_P[g] = *error->end;
      if (readings_.errors == RepairReadings::Errors::both) {
        suspect_beside(g, *error, suspects);
      }
      report.errors.push_back(std::move(*error));
    }
  }

  void suspect_beside(std::uint32_t g, const FacetError& error, IndexSet& suspects) const {
    const std::uint32_t start = Q_.start(g);
    std::uint32_t h = start;
    do {
      for (const std::uint32_t e : crossing_[Q_.edge(h)]) suspects.insert(e);
    } while ((h = Q_.next(h)) != start);
    if (readings_.search == RepairReadings::Search::ee_errors) return;
    for (const FacetError::Step& step : error.steps) {
      for (std::uint32_t d = P_.first(step.vertex); d < P_.first(step.vertex + 1); ++d) {
        if (P_.target(d) == step.witness) suspects.insert(P_.edge(d));
      }
    }
  }

  void mend_chains(RepairReport& report, IndexSet& suspects) {
    using Search = RepairReadings::Search;
    if (readings_.search == Search::everywhere) {
      for (std::uint32_t e = 0; e < P_.edges(); ++e) suspects.insert(e);
    }
    // The list grows during the loop: each ee-error adds the edges connected to the error.
    for (std::size_t k = 0; k < suspects.members().size(); ++k) {
      look_for_interrupt();
      const std::uint32_t e = suspects.members()[k];
      const std::uint32_t h = P_.half_edge(e);
      Chain lost;
      for (const std::uint32_t d : state_.chains[e]) {
        if (!are_compatible(h, d)) lost.push_back(d);
      }
      report.ee_errors += lost.size();
      if (lost.empty() && readings_.search == Search::ee_errors) continue;
      ++report.chains_walked;
      ChainRepair repair = walk(e);
      if (repair.after == repair.before && !repair.stuck) continue;
      suspect_connected(e, lost, suspects);
      if (readings_.search != Search::ee_errors) suspect_connected(e, repair.after, suspects);
      state_.chains[e] = repair.after;
      report.chains.push_back(std::move(repair));
    }
  }

  /// Suspects edges of P that share a vertex with `e` and were paired with some edge of `links`.
  void suspect_connected(std::uint32_t e, const Chain& links, IndexSet& suspects) const {
    const std::uint32_t a = P_.origin(P_.half_edge(e)), b = P_.target(P_.half_edge(e));
    for (const std::uint32_t d : links) {
      for (const std::uint32_t other : crossing_[Q_.edge(d)]) {
        const std::uint32_t h = P_.half_edge(other);
        const std::uint32_t u = P_.origin(h), v = P_.target(h);
        if (u == a || u == b || v == a || v == b) suspects.insert(other);
      }
    }
  }

  /// Whether the arcs of two half-edges intersect, with regard to their directions.
  bool are_compatible(std::uint32_t h, std::uint32_t d) const {
    const int left = across_P_.side(P_.left(h), d), right = across_P_.side(P_.right(h), d);
    const int rising = across_Q_.side(Q_.left(d), h), falling = across_Q_.side(Q_.right(d), h);
    if (readings_.ties != RepairReadings::Ties::closed) {
      return left < 0 && right > 0 && rising > 0 && falling < 0;
    }
    // Parallel edges make no facet.
    if ((left == 0 && right == 0) || (rising == 0 && falling == 0)) return false;
    return left <= 0 && right >= 0 && rising >= 0 && falling <= 0;
  }

  /// "We check each of v1's incident edges to find the edge with which e is compatible. We then
  /// replace v1 with the vertex at the other end-point ..., and repeat, ignoring the incident edge
  /// which has already been found": the text does not ask for the direction of a crossing.
  ChainRepair walk(std::uint32_t e) const {
    const std::uint32_t h = P_.half_edge(e);
    ChainRepair repair;
    repair.edge = e;
    repair.before = state_.chains[e];
    std::uint32_t at = state_.vertex_of_Q[P_.left(h)];
    const std::uint32_t to = state_.vertex_of_Q[P_.right(h)];
    std::optional<std::uint32_t> found;
    while (at != to) {
      std::optional<std::uint32_t> next;
      for (std::uint32_t d = Q_.first(at); d < Q_.first(at + 1) && !next; ++d) {
        if (found && Q_.edge(d) == *found) continue;
        if (are_compatible(h, d)) {
          repair.after.push_back(d);
          next = d;
        } else if (are_compatible(h, Q_.twin(d))) {
          repair.after.push_back(Q_.twin(d));
          next = d;
        }
      }
      if (!next || repair.after.size() > Q_.edges()) {
        repair.stuck = true;
        break;
      }
      at = Q_.target(*next);
      found = Q_.edge(*next);
    }
    return repair;
  }

  const Arithmetic<T> arithmetic_;
  const RepairReadings readings_;
  const ConvexPolyhedron& P_;
  const ConvexPolyhedron& Q_;
  Scaling scaling_;
  Compatibility state_;
  NormalsAndEdges<T> across_P_, across_Q_;
  std::vector<std::vector<std::uint32_t>> crossing_;
};

}  // namespace

std::unique_ptr<PaperRepair> PaperRepair::make(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                                               const Scaling& first, const std::string& arithmetic,
                                               const RepairReadings& readings) {
  const FloatEnvironment standard;
  require_positive(first);
  return with_arithmetic(arithmetic,
                         [&]<class T>(const Arithmetic<T>& in) -> std::unique_ptr<PaperRepair> {
                           return std::make_unique<RepairIn<T>>(P, Q, first, in, readings);
                         });
}

std::vector<ClaimedFacet> claimed_facets(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                                         const Compatibility& compatibility) {
  std::vector<ClaimedFacet> result;
  for (std::uint32_t f = 0; f < P.facets(); ++f) {
    ClaimedFacet facet{ClaimedFacet::Kind::fv, {}};
    const std::uint32_t q = compatibility.vertex_of_Q[f];
    for_vertices_of(P, f, [&](std::uint32_t p) { facet.ring.push_back({p, q}); });
    result.push_back(std::move(facet));
  }
  for (std::uint32_t g = 0; g < Q.facets(); ++g) {
    ClaimedFacet facet{ClaimedFacet::Kind::vf, {}};
    const std::uint32_t p = compatibility.vertex_of_P[g];
    for_vertices_of(Q, g, [&](std::uint32_t q) { facet.ring.push_back({p, q}); });
    result.push_back(std::move(facet));
  }
  for (std::uint32_t e = 0; e < P.edges(); ++e) {
    const std::uint32_t a = P.origin(P.half_edge(e)), b = P.target(P.half_edge(e));
    for (const std::uint32_t d : compatibility.chains[e]) {
      const std::uint32_t q = Q.origin(d), r = Q.target(d);
      result.push_back({ClaimedFacet::Kind::ee, {{a, q}, {a, r}, {b, r}, {b, q}}});
    }
  }
  return result;
}

}  // namespace minkref::inline space
