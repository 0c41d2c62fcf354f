// What of an offset curve no edge blocks.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/blocked_part.hpp"

namespace minkref::inline disc {

/// A closed part of a patch that nothing blocks; `before` and `after`: what blocks beyond its ends,
/// or touches there, by the features that are there.
struct FreePart {
  std::uint32_t patch;
  PatchPlace from, to;
  std::vector<std::uint32_t> before, after;

  bool is_point = false;
};

/// In order along the patch. Parts of a single point are among them.
std::vector<FreePart> free_parts(const PatchesAt& at, std::uint32_t patch,
                                 std::vector<BlockedPart> blocked, OffsetCounts& counts);

}  // namespace minkref::inline disc
