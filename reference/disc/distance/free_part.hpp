// Unblocked parts of an offset curve.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/distance/blocked_part.hpp"

namespace minkref::inline disc {

/// A part of a patch that nothing blocks, closed and more than a point.
struct FreePart {
  std::uint32_t patch;
  PatchPlace from, to;
};

/// The free parts along the patch, in order, cut where another curve touches.
std::vector<FreePart> free_parts(const PatchesAt& at, std::uint32_t patch,
                                 std::vector<BlockedPart> blocked, OffsetCounts& counts);

}  // namespace minkref::inline disc
