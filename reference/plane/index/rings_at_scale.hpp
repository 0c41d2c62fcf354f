// The boundary at a single scale without an index: found by the static route, told as an index
// tells it.
#pragma once

#include <vector>

#include "reference/plane/index/index_rings.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// The rings of a sum, each vertex as an exact point. Holes and components are numbered afresh.
struct PointRings : RingShape {
  std::vector<Point> points;
};

/// The boundary of `sP + Q`. Exact. Cost: a static sum (minkowski_sum), and O(b) exact turns for a
/// boundary of b edges; with c components O(b c). `statistics` as minkowski_sum's.
PointRings rings_at_scale(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                          Statistics& statistics);

/// The same rings in a form of an index. O(b), and a greatest common divisor for each point of the
/// homogeneous form. Nearest doubles.
void write_rings(const PointRings& from, RoundedRings& to);
void write_rings(const PointRings& from, HomogeneousRings& to);
void write_rings(const PointRings& from, RationalRings& to);

}  // namespace minkref::inline plane
