// The scales at which a part on a path comes nearer to obstacles than a distance, by features.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/motion/clearance/near_piece.hpp"

namespace minkref::inline motion {

/// Scales between two ends; without an end they go on to infinity.
struct RootRange {
  RootNumber from;
  bool from_in = false;
  std::optional<RootNumber> to;
  bool to_in = false;
};

/// A vertex or an edge of the part, one of the obstacles, and a vertex or a segment of the path at
/// which they come near. One of the three at most is no vertex.
struct NearFeatures {
  TouchingFeature part, obstacle;
  std::uint32_t place = 0;  ///< number of the path's vertex, or of the segment that starts there
  bool on_segment = false;
};

/// The scales of such features.
struct NearRange {
  RootRange scales;
  std::optional<NearFeatures> features;  ///< none of joined ranges that end nowhere of interest
};

/// Finds the scales s > 0 at which x + s R is nearer to a set than c at some place x of a polyline,
/// by vertices and edges, as ranges whose union has them all, unless the interiors of both meet. At
/// `or_equal` those at the distance c belong to them. Exact: ends are roots of quadratic
/// polynomials. Certified intervals of doubles join what certainly overlaps. O(k n m) for k path
/// vertices and n, m vertices of the sets, memory O(ranges that doubles do not join).
std::vector<NearRange> near_scales(const PolygonSet& part, const PolygonSet& obstacles,
                                   const std::vector<Point>& path, const Rational& clearance,
                                   bool or_equal);

}  // namespace minkref::inline motion
