// The sum of polyhedra of any shape, with a boundary built from edges (Sec. 3; docs/space-sums.md).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/space/edges/boundary_edges.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

struct EdgeSum {
  PolyhedralSet set;
  std::uint64_t facets = 0;          ///< of the reduced convolution, in pieces
  std::uint64_t covered_facets = 0;  ///< of these, left out as cells cover them
  std::uint64_t near_pairs = 0;      ///< of the others, that may touch
  EdgeStatistics statistics;
  std::uint64_t edges = 0;  ///< of the boundary, before those that follow each other are joined
};

/// S P ⊕ Q for a factor for each axis. Operands must have passed `validate`; at least one is a
/// solid (BadInput "degenerate-operands" otherwise); the other may be a plane polygon, a segment or
/// a point. Exact. O(n log n + k) for k pairs and triples of facets of the convolution that meet,
/// beside the search for compatible pairs, which looks at all pairs. Cuts flat
/// faces into pieces for a gain of `least_gain` (flat_pieces.hpp), which never changes the set.
EdgeSum edge_sum(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling,
                 const BuildOptions& options = {}, double least_gain = usual_gain);

}  // namespace minkref::inline space
