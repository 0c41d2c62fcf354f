// The faces about an edge, sorted by half-plane, and the sectors between them.
#pragma once

#include "reference/space/surface/surface_edges.hpp"

namespace minkref::inline space {

/// Sets the mates of all half-edges. Exact. O(n log n). std::logic_error where the half-planes
/// about an edge do not bound interior and outside in turn.
void pair_faces_about_edges(SurfaceEdges& surface);

}  // namespace minkref::inline space
