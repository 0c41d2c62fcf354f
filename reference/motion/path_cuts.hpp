// A path at one scale, cut by segments.
#pragma once

#include <vector>

#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline motion {

/// Points of a path: its vertices, the points where a segment crosses, touches or leaves the path,
/// and a point between any two neighbours.
struct PathCuts {
  std::vector<Point> cuts, between;
};

/// Exact. O(k n + c log c) for k path segments, n others and c cuts. A path segment without length
/// gives a cut; so does a path with a single vertex.
PathCuts path_cuts(const std::vector<Point>& path, const std::vector<Segment>& segments);

}  // namespace minkref::inline motion
