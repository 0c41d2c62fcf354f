// The links of a moving boundary in the order of the rings, for stretches of scales.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/scalespace/moving_boundary.hpp"

namespace minkref {

/// A link while it is there, in the place that it has in its ring.
struct RingEntry {
  std::uint32_t link = 0;
  std::uint32_t first = 0, last = 0;  ///< intervals
};

/// Rings of the boundary over some intervals in a row. At each of them the entries that are there,
/// in this order, are its rings: a link that takes the place of others stands beside them.
struct RingBucket {
  std::uint32_t first = 0, last = 0;  ///< intervals
  std::vector<RingEntry> entries;
  std::vector<std::uint32_t> ring_ends;  ///< behind the last entry of each ring
};

/// Where the boundary touches itself its walks along the components are split into simple rings
/// (docs/definitions.md, "Canonical form"). O(sum of the rings that change at each event).
std::vector<RingBucket> ring_buckets(const SweptBoundary& swept, const MovingBoundary& boundary);

}  // namespace minkref
