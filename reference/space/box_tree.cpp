#include "reference/space/box_tree.hpp"

#include <numeric>

namespace minkref::inline space {
namespace {

double middle_along(const SpaceBox& box, std::size_t axis) {
  return box.low[axis] / 2 + box.high[axis] / 2;
}

}  // namespace

SpaceBoxTree::SpaceBoxTree(std::vector<SpaceBox> boxes)
    : items_(boxes.size()), sorted_(std::move(boxes)) {
  std::iota(items_.begin(), items_.end(), 0U);
  if (items_.empty()) return;
  nodes_.reserve(items_.size());
  build(0, static_cast<std::uint32_t>(items_.size()));
  std::vector<SpaceBox> ordered(sorted_.size());
  for (std::size_t i = 0; i < items_.size(); ++i) ordered[i] = sorted_[items_[i]];
  sorted_ = std::move(ordered);
}

// While building, sorted_ holds the boxes in their original order.
void SpaceBoxTree::build(std::uint32_t begin, std::uint32_t end) {
  look_for_interrupt();
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({SpaceBox{}, begin, end, 0});
  SpaceBox box, centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    const SpaceBox& b = sorted_[items_[i]];
    box.add(b);
    SpaceBox centre;
    for (std::size_t k = 0; k < 3; ++k) centre.low[k] = centre.high[k] = middle_along(b, k);
    centres.add(centre);
  }
  nodes_[at].box = box;
  if (end - begin <= leaf_size) return;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (centres.high[k] - centres.low[k] > centres.high[axis] - centres.low[axis]) axis = k;
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                   [&](std::uint32_t i, std::uint32_t j) {
                     return middle_along(sorted_[i], axis) < middle_along(sorted_[j], axis);
                   });
  build(begin, middle);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

}  // namespace minkref::inline space
