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

/// A point with the nearest doubles. Copies share the exact one.
struct SolidCorner {
  std::array<double, 3> rounded;
  std::shared_ptr<const HomogeneousPoint> exact;
};
/// The corners of a convex polygon in a plane, in order.
using CornerRing = std::vector<SolidCorner>;

SolidCorner solid_corner(const IntegerVector& point, const Integer& weight);
SolidCorner solid_corner(const SpacePoint& point);
SpacePoint exact_point(const SolidCorner& corner);

/// The sign of a - b in one coordinate. Exact.
int compare_along(const SolidCorner& a, const SolidCorner& b, std::size_t axis);

OrientedPlane reversed(const OrientedPlane& plane);

/// A plane that cuts: what is below it is kept.
class CuttingPlane {
 public:
  explicit CuttingPlane(OrientedPlane plane);
  const OrientedPlane& plane() const { return plane_; }

  /// 1 above the plane, where its normal points to; 0 on it; -1 below. Exact.
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

/// The sides of all corners, and whether there are some above and some below.
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

/// The corners of the convex hull of points in a plane, without those inside its edges;
/// counter-clockwise as seen along `axis`, along which the plane must not run. Fewer than three
/// where all points are on a line. Exact. O(n log n).
CornerRing convex_ring(std::vector<SolidCorner> points, std::size_t axis);
/// The same, counter-clockwise as seen from where the normal points to.
CornerRing convex_ring_about(std::vector<SolidCorner> points, const IntegerVector& normal);

}  // namespace minkref::inline space
