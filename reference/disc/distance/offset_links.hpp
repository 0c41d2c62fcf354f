// Which free part the boundary of the sum goes on with.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/distance/free_part.hpp"

namespace minkref::inline disc {

/// For each part the one that starts where it ends; where several do, the one with which it bounds
/// one wedge of the interior. Exact. O(n log n). Throws std::logic_error where there is none, which
/// would be a fault.
std::vector<std::uint32_t> offset_links(const PatchesAt& at, const std::vector<FreePart>& parts);

}  // namespace minkref::inline disc
