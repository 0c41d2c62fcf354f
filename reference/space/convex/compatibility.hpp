// The pairs that make up the sum of two convex polyhedra: the overlay of their Gaussian maps.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/space/convex/facet_contact.hpp"

namespace minkref::inline space {

/// For S P and Q in generic position (facet_contact.hpp: P moved by an infinitesimal linear map).
///
/// - fv-pairs: each facet of P with the vertex of Q farthest along the facet's normal;
/// - vf-pairs: each facet of Q with P's vertex, likewise;
/// - ee-pairs: each edge of P with the edges of Q whose arcs cross the edge's arc in the Gaussian
///   map, from the facet on the left of `half_edge(edge)` to the facet on the right. These
///   half-edges of Q form a chain: each starts where the previous one ends, the first at the left
///   facet's vertex.
struct Compatibility {
  std::vector<std::uint32_t> vertex_of_Q;          ///< by facet of P
  std::vector<std::uint32_t> vertex_of_P;          ///< by facet of Q
  std::vector<std::vector<std::uint32_t>> chains;  ///< by edge of P
  friend bool operator==(const Compatibility&, const Compatibility&) = default;
};

/// The predicates for one pair at one scaling.
struct Contacts {
  FacetContact across_P, across_Q;  ///< normals of P and edges of Q; normals of Q and edges of P

  Contacts(const ConvexPolyhedron& P, const ConvexPolyhedron& Q)
      : across_P(P, Q, FacetContact::Operand::normals_of_P),
        across_Q(Q, P, FacetContact::Operand::normals_of_Q) {}
  void rescale(const RoundedScaling& scaling) {
    across_P.rescale(scaling);
    across_Q.rescale(scaling);
  }
  void rescale(const Scaling& scaling) { rescale(RoundedScaling(scaling)); }
  std::uint64_t evaluations() const { return across_P.evaluations() + across_Q.evaluations(); }
  std::uint64_t exact_evaluations() const {
    return across_P.exact_evaluations() + across_Q.exact_evaluations();
  }
  const ConvexPolyhedron& P() const { return across_P.normals(); }
  const ConvexPolyhedron& Q() const { return across_P.edges(); }
};

/// The result of a search for the vertex compatible with a facet.
struct Climb {
  std::uint32_t vertex;
  std::uint32_t steps;  ///< edges walked
  double slack;  ///< how far the scaling may drift with the vertex certainly compatible still
};

/// From a vertex along the witness of the incompatibility, the edge that rises most, until no edge
/// rises (Sec. 6). Always ends at the vertex farthest along the normal: the edges at a vertex of a
/// convex polyhedron span its cone, so a vertex without a rising edge is farthest, and the height
/// grows with every step. Doubles decide which edge rises most: this choice changes the way, never
/// the end.
Climb climb(const FacetContact& contact, std::uint32_t facet, std::uint32_t vertex);

/// The same climb; if an edge rises at `vertex` and an estimate puts `other` higher, the climb
/// starts from `other`. `walked` receives the half-edges along the way.
Climb climb(const FacetContact& contact, std::uint32_t facet, std::uint32_t vertex,
            std::uint32_t other, std::vector<std::uint32_t>& walked);

/// Walks the chain of P's edge between the vertices for the facets on both sides: from the first
/// vertex's region, each time through the arc by which the edge's great circle leaves the region.
/// The great circle meets each convex region in one piece, so the walk follows the arc. `slacks`
/// receives each chain edge's slack, as `examine_link` gives it. Throws std::logic_error if the
/// walk shows that the given ends do not belong to the edge.
void walk_chain(const FacetContact& across_Q, std::uint32_t edge, std::uint32_t from,
                std::uint32_t to, std::vector<std::uint32_t>& chain, std::vector<double>& slacks);

/// Whether the great circle of the edge runs through the arc of a half-edge of Q, and how far the
/// scaling may drift with the answer certainly kept. A chain is right if all links are right and
/// the chain ends at the two facets' vertices.
struct LinkState {
  bool right;
  double slack;
};
LinkState examine_link(const FacetContact& across_Q, std::uint32_t edge, std::uint32_t half_edge);

/// Visits a facet's vertices in ring order.
template <class Visit>
void for_vertices_of(const ConvexPolyhedron& body, std::uint32_t facet, Visit visit) {
  const std::uint32_t start = body.start(facet);
  std::uint32_t h = start;
  do visit(body.origin(h));
  while ((h = body.next(h)) != start);
}

}  // namespace minkref::inline space
