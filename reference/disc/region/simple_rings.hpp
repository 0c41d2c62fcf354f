// The boundary of P ⊕ ρD as simple rings.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/distance/static_offset.hpp"

namespace minkref::inline disc {

struct SimpleRing {
  std::vector<std::uint32_t> pieces;  ///< one after the other, the sum on the left
  bool is_hole;
};

/// Whether a piece goes on smoothly into another: the next curve, or another part of the same one.
bool goes_on(const StaticOffset& offset, std::uint32_t piece, std::uint32_t next);

struct SimpleRings {
  std::vector<SimpleRing> rings;
  /// The number of parts into which the plane falls: components of the interior and of the
  /// complement. Components that touch may have a hole between them without a separate ring.
  std::size_t faces;
};

/// The rings, split at points visited more than once. Exact. O(n log n), and O(k^2) for k corners
/// that doubles do not tell apart.
SimpleRings simple_rings(const StaticOffset& offset);

}  // namespace minkref::inline disc
