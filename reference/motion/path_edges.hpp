// Edges that move with the scale, and the scales at which edges start or stop meeting a path.
#pragma once

#include <vector>

#include "reference/plane/moving/track.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline motion {

/// An edge between two tracks; `along` gives its direction at all scales.
struct PathEdge {
  Track from, to;
  Point along;
};

/// Adds the scales s > 0 at which an edge's end lies on the path, or a path vertex on the edge, and
/// did not at all scales; also the scales at which an edge's end equals a path vertex. Exact. O(k)
/// for k vertices.
void add_meeting_scales(const PathEdge& edge, const std::vector<Point>& path,
                        std::vector<Rational>& scales);

/// A convolution edge of O and -sR at which both may touch without an overlap: a vertex of the part
/// whose sides lie on the outer side of an edge of the obstacles, or with the roles exchanged;
/// touching rings count as ordered wedges. Every contact of R and O without an overlap lies on such
/// an edge, and equals an edge's end if two vertices touch. Exact. O(m n).
std::vector<PathEdge> contact_edges(const PolygonSet& part, const PolygonSet& obstacles);

}  // namespace minkref::inline motion
