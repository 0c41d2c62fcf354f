// For which scales a part passes along a path (Behar & Lien 2012, Section 8.1).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "reference/motion/scale_set.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline motion {

/// Whether a part and an obstacle may touch.
enum class ContactRule : std::uint8_t { allowed, forbidden };

/// Three ways to the valid scales that share as little as possible.
enum class PathRoute : std::uint8_t {
  pieces,    ///< one convex polygon in (t, s) for each pair of convex pieces and segment
  contacts,  ///< where contacts of a vertex and an edge start or stop lying on the path
  index      ///< where the path meets the sums of an index of all scales
};

/// A place on a polyline: on the segment from vertex `segment` to the next, at (1 - t) times the
/// first vertex plus t times the second. On a path with a single vertex, segment 0 and t = 0.
template <class PointType>
struct PathPlaceOf {
  std::uint32_t segment = 0;
  Rational t;
  PointType point;
};
using PathPlace = PathPlaceOf<Point>;

/// A vertex, or the edge that starts at the vertex.
struct TouchingFeature {
  bool is_edge = false;
  VertexId id;
  friend bool operator==(const TouchingFeature&, const TouchingFeature&) = default;
};

/// An end of valid scales, and the contact that causes it.
template <class PointType, class Feature>
struct PathBoundOf {
  Rational scale;
  /// Scales just above are invalid, since the part then meets the obstacles at the place: the
  /// contact blocks. Otherwise scales just below are invalid, and the contact frees the part.
  bool blocks = true;
  PathPlaceOf<PointType> at;
  Feature part, obstacle;  ///< touch at that place, at that scale
  PointType touching;      ///< where
};
using PathBound = PathBoundOf<Point, TouchingFeature>;

struct PathStatistics {
  std::uint64_t pieces_of_part = 0, pieces_of_obstacles = 0;
  std::uint64_t triples = 0;          ///< a piece of each and a segment of the path
  std::uint64_t exact_triples = 0;    ///< not left out by doubles
  std::uint64_t critical_scales = 0;  ///< that routes by critical scales looked at
};

template <class Bound>
struct ValidScalesOf {
  std::vector<ScaleRange> valid;  ///< ascending, apart
  std::vector<Bound> bounds;  ///< two at most for each range: ends that are no end of the window
  PathStatistics statistics;
};
using ValidScales = ValidScalesOf<PathBound>;

/// The scales s of the window at which the part s R, carried along the polyline with its origin on
/// it and never turned, does not meet the obstacles: with contact allowed, no place of the path has
/// common interior points (`int O` and `x + s int R`); with contact forbidden, no place has a
/// common point. A point or a segment counts with its relative interior. Exact: a union of
/// intervals, single scales included. Both sets must have passed `validate`. Throws BadInput
/// ("bad-path" for a path without vertices, "bad-window", "degenerate-operands" if both are a point
/// or a segment). O(k a b) doubles for k segments and a, b convex pieces, memory O(k (a + b)).
ValidScales valid_scales(const PolygonSet& part, const PolygonSet& obstacles,
                         const std::vector<Point>& path, ContactRule rule = ContactRule::allowed,
                         const ScaleWindow& window = {}, PathRoute route = PathRoute::pieces);

/// Whether each point of the set sees the origin within the set. Such a part's valid scales form
/// one interval from 0. Exact. O(n).
bool star_shaped(const PolygonSet& part);

/// Throw BadInput; names are "allowed", "forbidden" and the routes' names.
ContactRule contact_rule(std::string_view name);
PathRoute path_route(std::string_view name);

}  // namespace minkref::inline motion
