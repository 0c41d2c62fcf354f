// Rays to the left among edges: the edge that each meets first, by a tree of their boxes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "reference/no_entry.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline plane {

/// Boxes that certainly enclose the edges, mirrored, so that what lies near on the left comes
/// first. Exact if the questions are. O(log n) for a ray where few boxes of edges overlap, O(n) at
/// worst.
class RayTree {
 public:
  RayTree() = default;
  explicit RayTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (Box& box : boxes_) box = mirrored(box);
    tree_ = BoxTree(boxes_);
  }

  std::size_t size() const { return boxes_.size(); }

  /// The edge that the ray from `at` meets first, or `no_entry`. `passes(e)` tells whether the ray
  /// meets the edge, `is_nearer(e, other)` which of two it meets first. Asks for each edge whose
  /// box the ray meets before it ends at the nearest one found.
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
