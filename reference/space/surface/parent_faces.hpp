// Which faces of the operands the faces of a sum come from.
#pragma once

#include <vector>

#include "reference/space/polyhedron.hpp"
#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// A vertex, an edge or a face of each operand by its vertices, as they are numbered there.
struct FacePair {
  Face of_P, of_Q;
  friend bool operator==(const FacePair&, const FacePair&) = default;
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

/// For each face of `surface`, the surface of S P ⊕ Q, the pairs whose sum has area in common with
/// the face: a face and a vertex, a vertex and a face, or two edges; ascending. The sum of a pair
/// is a facet of the reduced convolution, or a part of one. Parallel features count if the
/// convolution takes them. Operands as for `edge_sum`. Exact. The time of the convolution and of
/// `parents`.
std::vector<std::vector<FacePair>> parent_faces(const SurfaceEdges& surface, const Polyhedron& P,
                                                const Polyhedron& Q, const Scaling& scaling);

}  // namespace minkref::inline space
