// Where linear conditions on a place of a segment and a scale hold.
#pragma once

#include <optional>
#include <vector>

#include "reference/paths/valid_scales.hpp"

namespace minkref::inline paths {

/// t_slope t + s_slope s + constant < 0, or <= 0.
struct StripCondition {
  Rational t_slope, s_slope, constant;
};

/// A corner of a polygon in (t, s); `far`: the point at infinity that all lines of constant t
/// share.
struct StripCorner {
  Rational t, s;
  bool far = false;
  friend bool operator==(const StripCorner&, const StripCorner&) = default;
};

/// The convex polygon of all (t, s) with 0 <= t <= 1 and s >= 0 that meet the conditions, closed;
/// empty where nothing meets them, as they are (`strict`: they exclude equality). `is_point`: t is
/// 0 only. Exact. O(n^2) for n conditions.
std::vector<StripCorner> strip_corners(const std::vector<StripCondition>& conditions, bool strict,
                                       bool is_point);

/// The scales of a convex polygon in (t, s), 0 <= t <= 1 and s >= 0, and the least t at its ends.
struct StripScales {
  Rational from;
  std::optional<Rational> to;  ///< none: all scales above `from`
  Rational t_at_from, t_at_to;
};

/// The scales at which some place of the segment meets all conditions; none where there is no
/// scale. `strict`: the conditions exclude equality, the scales lie strictly between the ends.
/// Otherwise both ends belong to them. `is_point`: t is 0 only. Exact. O(n^2) for n conditions.
std::optional<StripScales> strip_scales(const std::vector<StripCondition>& conditions, bool strict,
                                        bool is_point);

}  // namespace minkref::inline paths
