// A path at one scale, cut where segments meet it.
#pragma once

#include <vector>

#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline paths {

/// Points of a path: where segments cross it, touch it or stop running along it, its vertices, and
/// one point between any two of these.
struct PathCuts {
  std::vector<Point> cuts, between;
};

/// Exact. O(k n + c log c) for k segments of the path, n others and c cuts. A segment of the path
/// without length is a cut; a path of one vertex too.
PathCuts path_cuts(const std::vector<Point>& path, const std::vector<Segment>& segments);

}  // namespace minkref::inline paths
