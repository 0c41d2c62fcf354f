#include "reference/space/definition/summed_pieces.hpp"

#include <string>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/definition/convex_pieces.hpp"
#include "reference/space/definition/seam_covers.hpp"

namespace minkref::inline space {

std::vector<SumBody> summed_pieces(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling,
                                   std::size_t most, bool with_seams) {
  require_positive(scaling);
  if (P.empty() || Q.empty()) return {};
  if (!P.is_solid() && !Q.is_solid()) {
    throw BadInput("degenerate-operands", "both operands are points or segments",
                   "make one of them a solid (or the empty set)");
  }
  const auto pieces = [&](const Polyhedron& operand, const Polyhedron& other) {
    std::vector<Polyhedron> all = convex_pieces(operand);
    if (with_seams && operand.is_solid() && !other.is_solid()) {
      std::vector<Polyhedron> covers = seam_covers(operand, all);
      all.insert(all.end(), covers.begin(), covers.end());
    }
    return all;
  };
  const std::vector<Polyhedron> of_P = pieces(scaled(P, scaling), Q), of_Q = pieces(Q, P);
  if (of_P.size() * of_Q.size() > most) {
    throw LimitExceeded("too-many-pairs",
                        "the operands have " + std::to_string(of_P.size()) + " and " +
                            std::to_string(of_Q.size()) + " convex pieces, more pairs than the " +
                            std::to_string(most) + " that are summed at most",
                        "take the route edges, or simpler operands");
  }
  const std::vector<Summand> first(of_P.begin(), of_P.end()), second(of_Q.begin(), of_Q.end());
  std::vector<SumBody> bodies;
  for (const Summand& a : first) {
    for (const Summand& b : second) {
      look_for_interrupt_now();
      SumBody body = sum_of(a, b);
      if (!body.facets.empty()) bodies.push_back(std::move(body));
    }
  }
  return bodies;
}

}  // namespace minkref::inline space
