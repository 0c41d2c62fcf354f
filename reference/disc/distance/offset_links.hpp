// The free part with which the sum's boundary goes on.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/distance/free_part.hpp"

namespace minkref::inline disc {

/// For each part the successor, which starts at the part's end; among several, the successor that
/// bounds the same wedge of the interior. Exact. O(n log n). Throws std::logic_error if a part has
/// no successor, which would be a fault.
std::vector<std::uint32_t> offset_links(const PatchesAt& at, const std::vector<FreePart>& parts);

}  // namespace minkref::inline disc
