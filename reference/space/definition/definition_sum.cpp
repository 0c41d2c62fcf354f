#include "reference/space/definition/definition_sum.hpp"

#include "reference/number/float_environment.hpp"
#include "reference/space/definition/exposed_facets.hpp"
#include "reference/space/definition/summed_pieces.hpp"

namespace minkref::inline space {

PolyhedralSet definition_sum(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling) {
  const FloatEnvironment standard;
  return boundary_of_union(summed_pieces(P, Q, scaling, most_pairs_of_pieces));
}

}  // namespace minkref::inline space
