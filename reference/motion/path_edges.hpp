// Edges that move with the scale, and the scales at which they start or stop meeting a path.
#pragma once

#include <vector>

#include "reference/plane/moving/track.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline paths {

/// From one track to another; its direction is that of `along` at all scales.
struct PathEdge {
  Track from, to;
  Point along;
};

/// The scales s > 0 at which an end of the edge lies on the path, or a vertex of the path on the
/// edge, and did not at all scales; and those at which an end of the edge is a vertex of the path.
/// Exact. O(k) for k vertices.
void add_meeting_scales(const PathEdge& edge, const std::vector<Point>& path,
                        std::vector<Rational>& scales);

/// A convolution edge of O and -sR at which both may touch without an overlap: a vertex of the part
/// whose sides lie on the outer side of an edge of the obstacles, or the other way round, in the
/// order of wedges where rings touch. Every contact of R and O without an overlap is on one, and is
/// an end of one if it is a contact of two vertices. Exact. O(m n).
std::vector<PathEdge> contact_edges(const PolygonSet& robot, const PolygonSet& obstacles);

}  // namespace minkref::inline paths
