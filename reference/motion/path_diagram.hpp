// The picture that explains the valid scales: which places and scales collide, as convex polygons.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/motion/open_pieces.hpp"
#include "reference/motion/strip_polygon.hpp"
#include "reference/motion/valid_scales.hpp"

namespace minkref::inline motion {

/// The places (t, s) of one path segment at which two convex pieces collide: the inside of a convex
/// polygon and, with contact forbidden, its boundary too. Corners run counter-clockwise, with t to
/// the right and s upwards; only two if the segment is a point, and with contact forbidden only one
/// or two if the pieces merely touch.
struct BadPolygon {
  std::uint32_t segment = 0;
  std::uint32_t part = 0, obstacle = 0;  ///< the pieces, by number
  std::vector<StripPoint> corners;
};

struct PathDiagram {
  std::vector<ConvexCorners> part_pieces, obstacle_pieces;
  std::vector<BadPolygon> polygons;  ///< by segment, piece of the part, piece of the obstacles
};

/// All bad polygons of a path, cut off at the ends of the window. For 0 < t < 1 and s inside the
/// window, the place t of a segment collides at the scale s iff (t, s) lies inside one of the
/// segment's polygons (with contact forbidden: inside or on a side). For a point segment, s alone
/// decides. A collision at a segment's end goes on nearby: a scale s inside the window is valid iff
/// the line of s meets no polygon this way. The window has a greatest scale, and more than one
/// scale. Exact. Throws what valid_scales throws, and LimitExceeded for more than `most` polygons.
/// O(k a b) doubles for k segments and a, b pieces, and an exact polygon for each triple that
/// doubles do not leave out.
PathDiagram path_diagram(const PolygonSet& part, const PolygonSet& obstacles,
                         const std::vector<Point>& path, ContactRule rule,
                         const ScaleWindow& window, std::size_t most);

}  // namespace minkref::inline motion
