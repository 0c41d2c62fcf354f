// The boundary of the set that rings describe, however they overlap.
#pragma once

#include <cstdint>

#include "reference/plane/boundary/boundary_graph.hpp"

namespace minkref::inline plane {

/// The points that lie inside: those with a positive winding number, with one other than 0, or with
/// an odd one.
enum class FillRule : std::uint8_t { positive, nonzero, evenodd };

struct SetBoundary {
  BoundaryGraph graph;
  bool well_formed = true;  ///< every winding number is 0 or 1
};

/// The boundary of the set of points with a winding number of at least `least` > 0 with respect to
/// the rings. Exact.
SetBoundary set_boundary(const PolygonSet& rings, int least = 1);
/// The same of the set of points that a rule tells to lie inside.
SetBoundary set_boundary(const PolygonSet& rings, FillRule rule);

}  // namespace minkref::inline plane
