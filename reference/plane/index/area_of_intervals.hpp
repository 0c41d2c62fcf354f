// The sum's area between two events: a polynomial of the scale.
#pragma once

#include <array>
#include <vector>

#include "reference/plane/index/index_columns.hpp"
#include "reference/plane/index/moving_boundary.hpp"

namespace minkref::inline plane {

/// Coefficients of half the cross product of a link's ends: the link's part of the area.
std::array<Rational, 3> area_below(const Track& from, const Track& to);

/// The area during each interval, from fixed-point sums with known errors: exact coefficients would
/// be as long as all denominators of a boundary together. O(links + intervals).
std::vector<IndexArea> areas_of_intervals(const MovingBoundary& boundary,
                                          const BuildControl& control);

}  // namespace minkref::inline plane
