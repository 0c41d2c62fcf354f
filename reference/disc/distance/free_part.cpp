#include "reference/disc/distance/free_part.hpp"

#include <algorithm>
#include <utility>

namespace minkref::inline disc {

std::vector<FreePart> free_parts(const PatchesAt& at, std::uint32_t patch,
                                 std::vector<BlockedPart> blocked, OffsetCounts& counts) {
  const auto comes_before = [&](const PatchPlace& a, const PatchPlace& b) {
    return at.compare(patch, a, b, counts) < 0;
  };
  std::sort(blocked.begin(), blocked.end(),
            [&](const BlockedPart& a, const BlockedPart& b) { return comes_before(a.low, b.low); });
  std::vector<FreePart> found;
  PatchPlace reach = PatchPlace::At::start;
  for (const BlockedPart& part : blocked) {
    if (comes_before(reach, part.low)) found.push_back({patch, reach, part.low});
    if (comes_before(reach, part.high)) reach = part.high;
  }
  if (reach.at < PatchPlace::At::end) found.push_back({patch, reach, PatchPlace::At::end});
  return found;
}

}  // namespace minkref::inline disc
