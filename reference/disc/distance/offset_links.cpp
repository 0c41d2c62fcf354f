#include "reference/disc/distance/offset_links.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline disc {

std::vector<std::uint32_t> offset_links(const PatchesAt& at, const std::vector<FreePart>& parts) {
  std::vector<plane::Box> starts;
  for (const FreePart& part : parts) starts.push_back(box_of(at.position(part.patch, part.from)));
  const plane::BoxTree tree(std::move(starts));
  std::vector<std::uint32_t> links;
  std::vector<std::uint32_t> near;
  for (const FreePart& part : parts) {
    near.clear();
    tree.query(box_of(at.position(part.patch, part.to)), [&](std::uint32_t k) {
      near.push_back(k);
      return false;
    });
    if (near.size() > 1) {
      const RootPoint x = at.point(part.patch, part.to);
      std::erase_if(near, [&](std::uint32_t k) {
        return !are_same(x, at.point(parts[k].patch, parts[k].from));
      });
      if (near.size() > 1) {
        const auto turns_before = [&](std::uint32_t a, std::uint32_t b) {
          return at.turns_before(part.patch, x, parts[a].patch, parts[b].patch);
        };
        near = {*std::min_element(near.begin(), near.end(), turns_before)};
      }
    }
    if (near.empty()) {
      throw std::logic_error("an offset curve does not go on at the end of patch " +
                             std::to_string(part.patch));
    }
    links.push_back(near[0]);
  }
  return links;
}

}  // namespace minkref::inline disc
