// Points and planes of the route `definition`: exact, with doubles that settle most signs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// The point over a weight above zero; the four have no common factor.
struct HomogeneousPoint {
  IntegerVector point;
  Integer weight;
};

/// A point with the nearest doubles. Copies share the exact point.
struct SolidCorner {
  std::array<double, 3> rounded;
  std::shared_ptr<const HomogeneousPoint> exact;
};
/// A convex polygon's corners, in order, in a plane.
using CornerRing = std::vector<SolidCorner>;

SolidCorner solid_corner(const IntegerVector& point, const Integer& weight);
SolidCorner solid_corner(const SpacePoint& point);
SpacePoint exact_point(const SolidCorner& corner);

/// The sign of a - b along one axis. Exact.
int compare_along(const SolidCorner& a, const SolidCorner& b, std::size_t axis);

OrientedPlane reversed(const OrientedPlane& plane);

/// A cutting plane; the cut keeps the part below.
class CuttingPlane {
 public:
  explicit CuttingPlane(OrientedPlane plane);
  const OrientedPlane& plane() const { return plane_; }

  /// Returns 1 above the plane (towards the normal), 0 on the plane, -1 below. Exact.
  int side(const SolidCorner& corner) const;
  /// Where the segment between corners on different sides meets the plane. Exact.
  SolidCorner meeting(const SolidCorner& a, const SolidCorner& b) const;

 private:
  Integer height(const HomogeneousPoint& point) const;

  OrientedPlane plane_;
  IntegerVector normal_;  ///< of the equation in integers
  Integer offset_;
  std::array<double, 3> rounded_normal_{};
  double rounded_offset_ = 0, slack_ = 0;
};

/// The sides of all corners, and whether some lie above and some below.
struct RingSides {
  std::vector<std::int8_t> sides;
  bool above = false, below = false;
};
RingSides sides_of(const CornerRing& ring, const CuttingPlane& plane);

/// A convex polygon with corners on both sides, cut in two.
struct RingHalves {
  CornerRing below, above;
};
RingHalves halves(const CornerRing& ring, const RingSides& sides, const CuttingPlane& plane);

/// The convex hull's corners for coplanar points, without points inside the hull's edges;
/// counter-clockwise seen along `axis`, which must not run along the plane. Fewer than three if all
/// points lie on a line. Exact. O(n log n).
CornerRing convex_ring(std::vector<SolidCorner> points, std::size_t axis);
/// The same, counter-clockwise as seen from where the normal points to.
CornerRing convex_ring_about(std::vector<SolidCorner> points, const IntegerVector& normal);

}  // namespace minkref::inline space
