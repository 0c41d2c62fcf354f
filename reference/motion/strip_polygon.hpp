// The region where linear conditions on a segment's place and a scale hold.
#pragma once

#include <optional>
#include <vector>

#include "reference/motion/valid_scales.hpp"

namespace minkref::inline motion {

/// t_slope t + s_slope s + constant < 0, or <= 0.
struct StripCondition {
  Rational t_slope, s_slope, constant;
};

/// A place of a segment, and a scale.
struct StripPoint {
  Rational t, s;
  friend bool operator==(const StripPoint&, const StripPoint&) = default;
};

/// A convex polygon in (t, s), 0 <= t <= 1 and s >= 0, perhaps without area.
struct StripPolygon {
  std::vector<StripPoint> corners;  ///< counter-clockwise, one at least
  bool endless = false;             ///< it goes on upwards
};

/// Its scales, and the least t at their ends.
struct StripScales {
  Rational from;
  std::optional<Rational> to;  ///< none: all scales above `from`
  Rational t_at_from, t_at_to;
};

/// The segment's places and the scales that meet all conditions: a polygon. With `strict`
/// conditions, which exclude equality, the sides on a condition do not belong to the region. None
/// without any place. `is_point`: only t = 0. Exact. O(n^2) for n conditions.
std::optional<StripPolygon> strip_polygon(const std::vector<StripCondition>& conditions,
                                          bool strict, bool is_point);

/// The infimum of the places that meet all conditions at a scale; none without such a place. Exact.
/// O(n).
std::optional<Rational> least_place(const std::vector<StripCondition>& conditions,
                                    const Rational& scale, bool strict, bool is_point);

/// Exact. O(n).
StripScales scales_of(const StripPolygon& polygon);

}  // namespace minkref::inline motion
