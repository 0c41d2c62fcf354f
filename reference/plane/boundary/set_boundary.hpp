// The boundary of the set that rings describe, however they overlap.
#pragma once

#include "reference/plane/boundary/boundary_graph.hpp"

namespace minkref::inline plane {

struct SetBoundary {
  BoundaryGraph graph;
  bool well_formed = true;  ///< every winding number is 0 or 1
};

/// The boundary of the set of points with a winding number of at least `least` > 0 with respect to
/// the rings. Exact.
SetBoundary set_boundary(const PolygonSet& rings, int least = 1);

}  // namespace minkref::inline plane
