// The picture that explains the valid scales: which places and scales collide, as convex polygons.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/motion/open_pieces.hpp"
#include "reference/motion/strip_polygon.hpp"
#include "reference/motion/valid_scales.hpp"

namespace minkref::inline paths {

/// The places (t, s) of one segment of the path at which two convex pieces collide: the inside of a
/// convex polygon and, with contact forbidden, its boundary too. Corners are counter-clockwise with
/// t to the right and s upwards; there are two where the segment is a point, and with contact
/// forbidden one or two where the pieces only touch.
struct BadPolygon {
  std::uint32_t segment = 0;
  std::uint32_t part = 0, obstacle = 0;  ///< the pieces, by number
  std::vector<StripPoint> corners;
};

struct PathDiagram {
  std::vector<ConvexCorners> part_pieces, obstacle_pieces;
  std::vector<BadPolygon> polygons;  ///< by segment, piece of the part, piece of the obstacles
};

/// All bad polygons of a path, cut off at the ends of the window. For 0 < t < 1 and s inside of the
/// window, the place t of a segment collides at the scale s iff (t, s) is inside of one of its
/// polygons (with contact forbidden: inside or on a side). If the segment is a point, this holds
/// for s alone. A collision at an end of a segment goes on nearby: a scale s inside of the window
/// is valid iff the line of s meets no polygon in this way. The window has a greatest scale, and
/// more than one scale. Exact. Throws what valid_scales throws, and LimitExceeded for more than
/// `most` polygons. O(k a b) in doubles for k segments and a, b pieces, and an exact polygon for
/// each triple of them that doubles do not leave out.
PathDiagram path_diagram(const PolygonSet& robot, const PolygonSet& obstacles,
                         const std::vector<Point>& path, ContactRule rule,
                         const ScaleWindow& window, std::size_t most);

}  // namespace minkref::inline paths
