// Rays to the left among edges: finds the first edge along each ray with a tree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "reference/no_entry.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline plane {

/// A tree over boxes that certainly enclose the edges, mirrored: near edges on the left come first.
/// As exact as the questions. O(log n) for a ray if few boxes overlap, O(n) at worst.
class RayTree {
 public:
  RayTree() = default;
  explicit RayTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (Box& box : boxes_) box = mirrored(box);
    tree_ = BoxTree(boxes_);
  }

  std::size_t size() const { return boxes_.size(); }

  /// Returns the first edge along the ray from `at`, or `no_entry`. `passes(e)`: whether the ray
  /// meets the edge; `is_nearer(e, before)`: whether it meets e before the second. Asks about each
  /// box up to the nearest edge so far.
  template <class Passes, class IsNearer>
  std::uint32_t first(const Box& at, Passes&& passes, IsNearer&& is_nearer) const {
    std::uint32_t nearest = no_entry;
    Box ray = mirrored(at);
    ray.xmax = std::numeric_limits<double>::infinity();
    tree_.query(ray, [&](std::uint32_t e) {
      if (!passes(e) || (nearest != no_entry && !is_nearer(e, nearest))) return false;
      nearest = e;
      // A nearer edge reaches farther to the right than this one's leftmost point.
      ray.xmax = std::min(ray.xmax, boxes_[e].xmax);
      return false;
    });
    return nearest;
  }

 private:
  static Box mirrored(const Box& box) { return {-box.xmax, box.ymin, -box.xmin, box.ymax}; }

  std::vector<Box> boxes_;  ///< mirrored
  BoxTree tree_;
};

}  // namespace minkref::inline plane
