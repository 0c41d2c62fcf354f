// The operands' faces from which a sum's faces come.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"
#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// A vertex, an edge or a face from each operand, as vertex numbers there.
struct FacePair {
  Face of_P, of_Q;
  friend bool operator==(const FacePair&, const FacePair&) = default;
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

/// For each face of `surface`, the surface of S P ⊕ Q, the pairs whose sum shares area with the
/// face: a face and a vertex, a vertex and a face, or two edges; ascending. A pair's sum is a facet
/// of the reduced convolution, or part of a facet. Parallel features count if the convolution takes
/// them. Operands as for `edge_sum`. Exact. Takes as long as the convolution and `parents`
/// together.
std::vector<std::vector<FacePair>> parent_faces(const SurfaceEdges& surface, const Polyhedron& P,
                                                const Polyhedron& Q, const Scaling& scaling);

}  // namespace minkref::inline space
