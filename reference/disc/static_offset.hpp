// P ⊕ ρD at one radius, from the definition: what is at the distance ρ from P and not nearer.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/blocked_part.hpp"

namespace minkref::inline disc {

/// A part of an offset curve on the boundary of the sum.
struct OffsetPiece {
  std::uint32_t patch;
  PatchPlace from, to;
};

struct StaticOffset {
  OffsetCurves curves;
  Rational squared_radius;
  std::vector<OffsetPiece> pieces;
  /// Each ring by the numbers of its pieces, one after the other, the sum on the left. Where it
  /// only touches itself, rings go round its interior.
  std::vector<std::vector<std::uint32_t>> rings;
};

/// Of a valid polygon set, a point or a segment, squared_radius > 0. By all edges for each patch:
/// O(n^2), beside sorting. Exact. Throws std::logic_error where pieces do not close up, which would
/// be a fault.
StaticOffset static_offset(const PolygonSet& P, const Rational& squared_radius);

}  // namespace minkref::inline disc
