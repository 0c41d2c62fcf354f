#include "reference/space/convex/static_convex_sum.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline space {
namespace {

/// Finds each facet's vertex on the other body, from neighbour to neighbour.
std::vector<std::uint32_t> vertices_by_traversal(const FacetContact& contact) {
  std::vector<std::uint32_t> vertex(contact.normals().facets());
  for (const auto& [facet, before] : contact.normals().traversal()) {
    look_for_interrupt();
    vertex[facet] = climb(contact, facet, vertex[before]).vertex;
  }
  return vertex;
}

std::vector<std::uint32_t> vertices_by_brute_force(const FacetContact& contact) {
  const ConvexPolyhedron& body = contact.edges();
  std::vector<std::uint32_t> result;
  for (std::uint32_t f = 0; f < contact.normals().facets(); ++f) {
    std::uint32_t found = UINT32_MAX;
    for (std::uint32_t v = 0; v < body.vertices(); ++v) {
      look_for_interrupt();
      bool rises = false;
      for (std::uint32_t h = body.first(v); h < body.first(v + 1); ++h) {
        rises = rises || contact.rises(f, h);
      }
      if (rises) continue;
      if (found != UINT32_MAX) throw std::logic_error("two vertices are compatible with a facet");
      found = v;
    }
    result.push_back(found);
  }
  return result;
}

}  // namespace

Compatibility by_traversal(const Contacts& contacts) {
  const FloatEnvironment standard;
  const ConvexPolyhedron& P = contacts.P();
  Compatibility result{
      vertices_by_traversal(contacts.across_P), vertices_by_traversal(contacts.across_Q), {}};
  result.chains.resize(P.edges());
  std::vector<double> slacks;
  for (std::uint32_t e = 0; e < P.edges(); ++e) {
    look_for_interrupt();
    const std::uint32_t h = P.half_edge(e);
    walk_chain(contacts.across_Q, e, result.vertex_of_Q[P.left(h)], result.vertex_of_Q[P.right(h)],
               result.chains[e], slacks);
  }
  return result;
}

Compatibility by_brute_force(const Contacts& contacts) {
  const FloatEnvironment standard;
  const ConvexPolyhedron &P = contacts.P(), &Q = contacts.Q();
  Compatibility result{
      vertices_by_brute_force(contacts.across_P), vertices_by_brute_force(contacts.across_Q), {}};
  result.chains.resize(P.edges());
  for (std::uint32_t e = 0; e < P.edges(); ++e) {
    const std::uint32_t h = P.half_edge(e);
    std::vector<std::uint32_t> crossed;
    for (std::uint32_t d = 0; d < Q.half_edges(); ++d) {
      look_for_interrupt();
      // The arcs of h and d both run from the left facet to the right one.
      if (!contacts.across_P.rises(P.left(h), d) && contacts.across_P.rises(P.right(h), d) &&
          contacts.across_Q.rises(Q.left(d), h) && !contacts.across_Q.rises(Q.right(d), h)) {
        crossed.push_back(d);
      }
    }
    // Along the arc each edge starts where the previous one ends.
    std::vector<std::uint32_t>& chain = result.chains[e];
    std::uint32_t at = result.vertex_of_Q[P.left(h)];
    while (chain.size() < crossed.size()) {
      const auto next = std::find_if(crossed.begin(), crossed.end(),
                                     [&](std::uint32_t d) { return Q.origin(d) == at; });
      if (next == crossed.end()) throw std::logic_error("the edges crossed by an arc are no chain");
      chain.push_back(*next);
      at = Q.target(*next);
    }
  }
  return result;
}

}  // namespace minkref::inline space
