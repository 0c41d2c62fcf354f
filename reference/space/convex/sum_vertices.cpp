#include "reference/space/convex/sum_vertices.hpp"

#include "reference/space/convex/compatibility.hpp"

namespace minkref::inline space {

SumVertices::SumVertices(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                         const Compatibility& compatibility)
    : P_(&P), Q_(&Q), met_(P.vertices()), whole_(Q.vertices(), none), seen_(Q.vertices()) {
  for (std::uint32_t p = 0; p < P.vertices(); ++p) renew_at_P(p, compatibility);
  for (std::uint32_t q = 0; q < Q.vertices(); ++q) renew_at_Q(q, compatibility);
}

void SumVertices::renew_at_P(std::uint32_t p, const Compatibility& compatibility) {
  ++call_;
  std::vector<std::uint32_t>& met = met_[p];
  met_count_ -= met.size();
  met.clear();
  const auto add = [&](std::uint32_t q) {
    if (seen_[q] == call_) return;
    seen_[q] = call_;
    met.push_back(q);
  };
  for (std::uint32_t h = P_->first(p); h < P_->first(p + 1); ++h) {
    // Every region along the arc but the last starts an edge of the chain; the facet on a
    // half-edge's left is an end of the arc.
    add(compatibility.vertex_of_Q[P_->left(h)]);
    for (const std::uint32_t d : compatibility.chains[P_->edge(h)]) {
      add(Q_->origin(d));
      add(Q_->target(d));
    }
  }
  met_count_ += met.size();
}

void SumVertices::renew_at_Q(std::uint32_t q, const Compatibility& compatibility) {
  const std::uint32_t p = compatibility.vertex_of_P[Q_->left(Q_->first(q))];
  bool whole = true;
  for (std::uint32_t h = Q_->first(q) + 1; whole && h < Q_->first(q + 1); ++h) {
    whole = compatibility.vertex_of_P[Q_->left(h)] == p;
  }
  whole_count_ -= whole_[q] != none;
  whole_[q] = whole ? p : none;
  whole_count_ += whole;
}

std::vector<SumVertices::Pair> SumVertices::pairs() const {
  std::vector<Pair> result;
  result.reserve(size());
  for_each([&](std::uint32_t p, std::uint32_t q) { result.push_back({p, q}); });
  return result;
}

}  // namespace minkref::inline space
