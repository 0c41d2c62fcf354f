#include "reference/disc/free_part.hpp"

#include <algorithm>
#include <utility>

namespace minkref::inline disc {
namespace {

using At = PatchPlace::At;

void append(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& features) {
  to.insert(to.end(), features.begin(), features.end());
}

}  // namespace

std::vector<FreePart> free_parts(const PatchesAt& at, std::uint32_t patch,
                                 std::vector<BlockedPart> blocked, OffsetCounts& counts) {
  const auto compare = [&](const PatchPlace& a, const PatchPlace& b) {
    return at.compare(patch, a, b, counts);
  };
  std::sort(blocked.begin(), blocked.end(),
            [&](const BlockedPart& a, const BlockedPart& b) { return compare(a.low, b.low) < 0; });
  std::vector<FreePart> found;
  const auto add = [&](FreePart part) {
    part.is_point = compare(part.from, part.to) == 0;
    found.push_back(std::move(part));
  };
  PatchPlace reach = At::start;
  std::vector<std::uint32_t> before;
  bool is_open = true;  // whether the patch is free at its start
  std::size_t k = 0;
  for (; k < blocked.size() && blocked[k].low.at == At::before; ++k) {
    const int order = is_open ? 1 : compare(blocked[k].high, reach);
    if (order > 0) {
      reach = blocked[k].high;
      before = blocked[k].high_features;
    } else if (order == 0) {
      append(before, blocked[k].high_features);
    }
    is_open = false;
  }
  for (; k < blocked.size(); ++k) {
    if (compare(blocked[k].low, reach) >= 0) {
      FreePart part{patch, reach, blocked[k].low, before, {}};
      for (std::size_t l = k; l < blocked.size(); ++l) {
        if (compare(blocked[l].low, part.to) != 0) break;
        append(part.after, blocked[l].low_features);
      }
      add(std::move(part));
      reach = blocked[k].high;
      before = blocked[k].high_features;
      continue;
    }
    const int order = compare(blocked[k].high, reach);
    if (order > 0) {
      before = blocked[k].high_features;
      reach = blocked[k].high;
    } else if (order == 0) {
      append(before, blocked[k].high_features);
    }
  }
  if (reach.at != At::beyond) add({patch, reach, At::end, before, {}});
  return found;
}

}  // namespace minkref::inline disc
