// The largest disc whose centre follows a path past obstacles.
#pragma once

#include <optional>
#include <vector>

#include "reference/disc/clearance/segment_distance.hpp"

namespace minkref::inline disc {

/// A point of a polyline: on the segment from vertex `segment` to the next, the fraction t along.
struct DiscPlace {
  std::uint32_t segment = 0;
  Rational t;
  Point point;
};

/// A contact of a disc with a set: with its vertex, or the inside of an edge.
struct DiscContact {
  DiscPlace at;  ///< of the disc's centre
  bool is_edge = false;
  VertexId feature;  ///< the vertex, or where the edge starts
  Point touching;
};

/// The least distance of a path and a set.
struct DiscOnPath {
  Rational squared_radius;  ///< 0 iff the path meets the set
  /// The first along the path, there with the least ring and index; none iff the path starts
  /// inside of the set.
  std::optional<DiscContact> contact;
};

/// Finds the largest radius ρ at which the open disc ρD misses a set all along a polyline of its
/// centre: the least distance of both. So the valid radii are those up to ρ; ρ is one iff contact
/// is allowed, and there is none if ρ = 0. Exact: the square is rational. The set is a valid
/// polygon set, a point or a segment; none for the empty set. Throws BadInput ("bad-path") for a
/// path without vertices. O(n log n + k) for n edges and segments, and k pairs of boxes that are
/// nearer than what was found before. Behar & Lien 2012, Section 8.1.
std::optional<DiscOnPath> largest_disc_on_path(const PolygonSet& obstacles,
                                               const std::vector<Point>& path);

}  // namespace minkref::inline disc
