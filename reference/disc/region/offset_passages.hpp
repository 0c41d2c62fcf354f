// Tight passages of P ⊕ ρD: what the closed sum covers and the sum of the interiors does not.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// A point, or a segment by its ends, the lesser one (x, then y) first.
struct OffsetPassage {
  std::vector<RootPoint> points;
  /// Features that are at the distance of the radius: of a point all, of a segment those that it
  /// runs along. Ascending.
  std::vector<std::uint32_t> contacts;
};

/// The closure of the points with the distance ρ from P around which none is farther
/// (docs/disc.md), in the order of their points. No two share more than a point. Exact. All pairs
/// of a curve and an edge near it, as static_offset looks at them, on `options.threads`.
std::vector<OffsetPassage> offset_passages(const PatchesAt& at, const BuildOptions& options = {});

}  // namespace minkref::inline disc
