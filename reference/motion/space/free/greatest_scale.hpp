// The greatest scale under linear conditions on a place and the scale: a linear program, exact.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// normal · x + reach s <= offset, for a place x and a scale s.
struct ScaleCondition {
  SpacePoint normal;
  Rational reach, offset;
};

/// A condition's share of the proof: no greater scale is possible.
struct ScaleWeight {
  std::size_t condition = 0;
  Rational weight;  ///< above 0
};

/// The optimum, and its proof: the named conditions, weighted, sum to s <= scale.
struct GreatestScale {
  Rational scale;
  SpacePoint at;                     ///< meets all conditions with this scale
  std::vector<ScaleWeight> weights;  ///< four at most, by conditions
  bool is_by_start = false;          ///< a start condition has a weight too
};

/// Finds the greatest s with a place that meets all conditions. `start`: four conditions with
/// independent rows (normal, reach), the first two with opposite normals and a positive sum of
/// reaches. If they hold strictly at each optimum without them, they never have a weight.
///
/// The dual simplex method with Bland's rule, on four conditions at a time. Exact: the weights
/// prove the result, and are checked. O(n) products for each exchange of a condition. Throws
/// std::logic_error if no place meets the conditions at any scale.
GreatestScale greatest_scale(const std::vector<ScaleCondition>& conditions,
                             const std::array<ScaleCondition, 4>& start);

/// Conditions `start` that put a place into a box widened by 1 on each side of the axes, each with
/// the reach of the part's box [low, high], which has a width along `axis`.
std::array<ScaleCondition, 4> box_conditions(std::size_t axis, const SpacePoint& low,
                                             const SpacePoint& high, const SpacePoint& least,
                                             const SpacePoint& greatest);

}  // namespace minkref::inline space
