// The sum's vertices: pairs of a P vertex and a Q vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/convex/convex_polyhedron.hpp"

namespace minkref::inline space {

struct Compatibility;

/// All pairs (p, q) whose regions in the two Gaussian maps overlap: their sums are the corners of
/// the sum's facets, in generic position. Either an arc of P at p's region runs through q's region,
/// or q's whole region lies within p's: then all facets at q are compatible with p.
class SumVertices {
 public:
  struct Pair {
    std::uint32_t p, q;
    friend bool operator==(const Pair&, const Pair&) = default;
  };

  /// O(edges + ee-pairs).
  SumVertices(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
              const Compatibility& compatibility);

  /// After the chain of an edge at p changed.
  void renew_at_P(std::uint32_t p, const Compatibility& compatibility);
  /// Renews after a facet at q changed its vertex of P.
  void renew_at_Q(std::uint32_t q, const Compatibility& compatibility);

  std::size_t size() const { return met_count_ + whole_count_; }
  /// The partners of p whose regions arcs at p run through; first in the order below, p after p.
  const std::vector<std::uint32_t>& met(std::uint32_t p) const { return met_[p]; }
  /// Whether q's region lies within a partner's; such pairs come last below, q after q.
  bool is_whole(std::uint32_t q) const { return whole_[q] != none; }
  /// In no particular order, but always the same for the same pairs of facets, vertices and edges.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::uint32_t p = 0; p < met_.size(); ++p) {
      for (const std::uint32_t q : met_[p]) visit(p, q);
    }
    for (std::uint32_t q = 0; q < whole_.size(); ++q) {
      if (whole_[q] != none) visit(whole_[q], q);
    }
  }
  std::vector<Pair> pairs() const;

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  const ConvexPolyhedron* P_;
  const ConvexPolyhedron* Q_;
  std::vector<std::vector<std::uint32_t>> met_;  // by p: whose regions the arcs at p run through
  std::vector<std::uint32_t> whole_;             // by q: in whose region its own lies
  std::size_t met_count_ = 0, whole_count_ = 0;
  std::vector<std::uint64_t> seen_;  // by q: in which call of renew_at_P it was met
  std::uint64_t call_ = 0;
};

}  // namespace minkref::inline space
