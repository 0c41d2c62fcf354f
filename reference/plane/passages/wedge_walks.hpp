// The boundary of an operand whose rings touch, walked wedge by wedge of its interior.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"

namespace minkref::inline plane {

/// Where rings touch, the interior of the set is parted although the set is not. The rings turn
/// there from one part to the next; the walks stay along one, and their convolution holds the
/// boundary of the sum of the interiors, which that of the rings need not.
struct WedgeWalks {
  PolygonSet walks;  ///< each closed walk as a ring of its own; it may pass a point again
  /// For each vertex of a walk, the edge of the operand that the walk's edge from there is (or is a
  /// part of), and the vertex of the operand.
  std::vector<std::vector<VertexId>> edge_names, vertex_names;
};

/// None where no two rings touch (and for a point or a segment): the rings are the walks. Exact.
/// O(n log n) on usual input.
std::optional<WedgeWalks> wedge_walks(const PolygonSet& set);

/// An edge of the convolution of walks (or of rings, where they are none) by its parents in the
/// operands.
ConvolutionEdge in_operands(ConvolutionEdge edge, const std::optional<WedgeWalks>& P,
                            const std::optional<WedgeWalks>& Q);

}  // namespace minkref::inline plane
