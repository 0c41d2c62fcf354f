// P ⊕ ρD at one radius, from the definition: the points at the distance ρ from P and not nearer.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// A part of an offset curve on the sum's boundary.
struct OffsetPiece {
  std::uint32_t patch;
  PatchPlace from, to;
};

struct StaticOffset {
  std::shared_ptr<const PatchesAt> at;
  std::vector<OffsetPiece> pieces;
  /// Each ring as the numbers of consecutive pieces, with the sum on the left. If several rings
  /// meet at a point, each goes round a wedge of the interior.
  std::vector<std::vector<std::uint32_t>> rings;
  OffsetCounts counts;
};

/// The boundary of P ⊕ ρD, for a valid polygon set, a point or a segment, and squared_radius > 0.
/// Exact. Compares each curve not certainly inside with all edges that may be nearer than the
/// radius: O(n log n + k) for k such pairs, on `options.threads`. Throws std::logic_error if pieces
/// do not close up, which would be a fault.
StaticOffset static_offset(const PolygonSet& P, const Rational& squared_radius,
                           const BuildOptions& options = {});

}  // namespace minkref::inline disc
