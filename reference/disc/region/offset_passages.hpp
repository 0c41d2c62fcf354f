// Tight passages of P ⊕ ρD: the points that the closed sum covers and the sum of the interiors does
// not.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// A point, or a segment's two ends, the lesser end (x, then y) first.
struct OffsetPassage {
  std::vector<RootPoint> points;
  /// Features at the distance of the radius: for a point all, for a segment the features along
  /// which the segment runs. Ascending.
  std::vector<std::uint32_t> contacts;
};

/// The closure of the points at the distance ρ from P without farther points around (docs/disc.md),
/// ordered by their points. No two share more than a point. Exact. Examines all pairs of a curve
/// and a nearby edge, as static_offset does, on `options.threads`.
std::vector<OffsetPassage> offset_passages(const PatchesAt& at, const BuildOptions& options = {});

}  // namespace minkref::inline disc
