#include "reference/plane/arrangement/box_tree.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"

namespace minkref::inline plane {

BoxTree::BoxTree(std::vector<Box> boxes) : items_(boxes.size()), sorted_(std::move(boxes)) {
  std::iota(items_.begin(), items_.end(), 0U);
  if (items_.empty()) return;
  nodes_.reserve(items_.size());
  build(0, static_cast<std::uint32_t>(items_.size()));
  std::vector<Box> ordered(sorted_.size());
  for (std::size_t i = 0; i < items_.size(); ++i) ordered[i] = sorted_[items_[i]];
  sorted_ = std::move(ordered);
}

// While building, sorted_ holds the boxes in their original order.
void BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  look_for_interrupt();
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({Box{}, begin, end, 0});
  Box box, centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Box& b = sorted_[items_[i]];
    box.add(b);
    const double x = b.xmin / 2 + b.xmax / 2, y = b.ymin / 2 + b.ymax / 2;
    centres.add({x, y, x, y});
  }
  nodes_[at].box = box;
  if (end - begin <= leaf_size) return;
  const bool along_x = centres.xmax - centres.xmin > centres.ymax - centres.ymin;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                   [&](std::uint32_t i, std::uint32_t j) {
                     const Box& a = sorted_[i];
                     const Box& b = sorted_[j];
                     return along_x ? a.xmin / 2 + a.xmax / 2 < b.xmin / 2 + b.xmax / 2
                                    : a.ymin / 2 + a.ymax / 2 < b.ymin / 2 + b.ymax / 2;
                   });
  build(begin, middle);
  nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

}  // namespace minkref::inline plane
