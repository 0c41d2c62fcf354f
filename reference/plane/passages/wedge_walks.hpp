// The boundary of an operand with touching rings, walked wedge by wedge of its interior.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"

namespace minkref::inline plane {

/// Touching rings part the interior of the set, although the set stays connected. There the rings
/// turn from one part to the next; the walks stay along one part, and their convolution holds the
/// boundary of the interiors' sum, unlike, possibly, the rings' convolution.
struct WedgeWalks {
  PolygonSet walks;  ///< each closed walk as a ring of its own; it may pass a point again
  /// For each vertex of a walk, the operand's edge that contains the walk's outgoing edge, and the
  /// operand's vertex.
  std::vector<std::vector<VertexId>> edge_names, vertex_names;
};

/// None where no two rings touch (and for a point or a segment): the rings are the walks. Exact.
/// O(n log n) on usual input.
std::optional<WedgeWalks> wedge_walks(const PolygonSet& set);

/// Names an edge of the convolution of walks (or of rings, without walks) by its parents from the
/// operands.
ConvolutionEdge in_operands(ConvolutionEdge edge, const std::optional<WedgeWalks>& P,
                            const std::optional<WedgeWalks>& Q);

}  // namespace minkref::inline plane
