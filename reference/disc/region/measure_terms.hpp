// Area and length of P ⊕ ρD, exact, as term sums.
#pragma once

#include <vector>

#include "reference/disc/region/offset_region.hpp"
#include "reference/number/radicals/root_text.hpp"

namespace minkref::inline disc {

/// Counter-clockwise from one direction to another; equal directions are a whole turn.
struct TermAngle {
  RootPoint from, to;
};

/// With Θ the angle sum, as radians, the length is the `length` sum plus ρ Θ, and the area is the
/// `area` sum plus ρ² Θ / 2.
struct MeasureTerms {
  RootTerms length, area;
  /// Angles of the boundary's arcs: one for each curve between two corners or joints.
  std::vector<TermAngle> angles;
};

/// Exact. O(n log n), and each corner in roots.
MeasureTerms measure_terms(const OffsetRegion& region);

}  // namespace minkref::inline disc
