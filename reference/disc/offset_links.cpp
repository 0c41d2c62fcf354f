#include "reference/disc/offset_links.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

namespace minkref::inline disc {

using At = PatchPlace::At;

OffsetLinks::OffsetLinks(const PatchesAt& at, const std::vector<FreePart>& parts)
    : at_(at), parts_(parts), starts_(at.curves().patches.size(), OffsetPatch::none) {
  for (std::uint32_t k = 0; k < parts.size(); ++k) {
    const FreePart& part = parts[k];
    if (part.from.at == At::start) starts_[part.patch] = k;
    for (const std::uint32_t feature : std::set(part.before.begin(), part.before.end())) {
      after_[{feature, feature_of(part)}].push_back(k);
    }
  }
}

std::uint32_t OffsetLinks::next(std::uint32_t k) const {
  const FreePart& part = parts_[k];
  if (part.to.at == At::end) {
    const std::uint32_t patch = at_.curves().patches[part.patch].next;
    if (patch != OffsetPatch::none && starts_[patch] != OffsetPatch::none) return starts_[patch];
  }
  std::vector<std::uint32_t> found;
  for (const std::uint32_t feature : std::set(part.after.begin(), part.after.end())) {
    const auto here = after_.find({feature_of(part), feature});
    if (here != after_.end()) found.insert(found.end(), here->second.begin(), here->second.end());
  }
  // Where another curve touches, the same one goes on.
  const bool goes_on =
      k + 1 < parts_.size() && parts_[k + 1].patch == part.patch && part.to.at == At::inside &&
      parts_[k + 1].from.at == At::inside && parts_[k + 1].from.by == part.to.by &&
      parts_[k + 1].from.curve == part.to.curve && parts_[k + 1].from.way == part.to.way;
  if (goes_on) found.push_back(k + 1);
  if (found.empty()) {
    throw std::logic_error("an offset curve does not go on at the end of patch " +
                           std::to_string(part.patch));
  }
  if (found.size() == 1) return found[0];
  const RootPoint x = at_.point(part.patch, part.to);
  return *std::min_element(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
    return at_.turns_before(part.patch, x, parts_[a].patch, parts_[b].patch);
  });
}

}  // namespace minkref::inline disc
