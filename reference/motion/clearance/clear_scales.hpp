// For which scales a part keeps a distance from obstacles on a path, or within a container.
#pragma once

#include <vector>

#include "reference/motion/clearance/near_scales.hpp"

namespace minkref::inline motion {

/// An end of the scales that are clear, and the features at the distance there.
struct ClearBound {
  RootNumber scale;
  bool blocks = true;  ///< the part is too near just above; otherwise just below
  NearFeatures features;
  RootNumber t;  ///< how far along the segment of the path
};

struct ClearScales {
  std::vector<RootRange> clear;  ///< ascending, apart
  std::vector<ClearBound> bounds;
};

/// The scales s of the window at which the part sR, carried along the polyline with its origin on
/// it and never turned, keeps the distance `clearance` > 0 from the obstacles (with contact
/// forbidden: more than that). Exact: each end is a rational number or the root of a quadratic
/// polynomial. Sets as for valid_scales. Throws BadInput as valid_scales, and "bad-clearance".
/// O(k n m) doubles for k vertices of the path and n, m of the sets. docs/paths.md.
ClearScales clear_scales(const PolygonSet& part, const PolygonSet& obstacles,
                         const std::vector<Point>& path, const Rational& clearance,
                         ContactRule rule = ContactRule::allowed, const ScaleWindow& window = {});

/// The scales at which the part lies inside of a container, at a place, and keeps the distance from
/// its boundary. Throws BadInput as scales_that_fit_at, and "bad-clearance".
ClearScales scales_clear_at(const PolygonSet& part, const PolygonSet& container, const Point& at,
                            const Rational& clearance, ContactRule rule = ContactRule::allowed);

}  // namespace minkref::inline motion
