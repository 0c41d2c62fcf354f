// A bounding-volume hierarchy over boxes in space: pairs that overlap, boxes that meet a box.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "reference/interrupt.hpp"

namespace minkref::inline space {

/// Closed. As made, nothing is inside.
struct SpaceBox {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

  void add(const SpaceBox& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  bool overlaps(const SpaceBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
  }
};

class SpaceBoxTree {
 public:
  SpaceBoxTree() = default;
  /// Median splits along the longest side of the centres' extent. O(n log n).
  explicit SpaceBoxTree(std::vector<SpaceBox> boxes);

  std::size_t size() const { return items_.size(); }

  /// Calls report(i) for every box that overlaps `box`; stops early when report returns true, and
  /// then returns true.
  template <class Report>
  bool query(const SpaceBox& box, Report&& report) const {
    return !nodes_.empty() && query_node(0, box, report);
  }

  /// Calls report(i, j), i and j different, once for every pair of boxes that overlap; stops early
  /// when report returns true, and then returns true.
  template <class Report>
  bool pairs(Report&& report) const {
    return !nodes_.empty() && self_pairs(0, report);
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Node {
    SpaceBox box;
    std::uint32_t begin, end;  ///< items
    std::uint32_t right;       ///< the right child, 0 for a leaf; the left child is the next node
    bool is_leaf() const { return right == 0; }
  };

  void build(std::uint32_t begin, std::uint32_t end);

  template <class Report>
  bool query_node(std::uint32_t at, const SpaceBox& box, Report& report) const {
    look_for_interrupt();
    const Node& node = nodes_[at];
    if (!node.box.overlaps(box)) return false;
    if (!node.is_leaf()) {
      return query_node(at + 1, box, report) || query_node(node.right, box, report);
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (sorted_[i].overlaps(box) && report(items_[i])) return true;
    }
    return false;
  }

  template <class Report>
  bool self_pairs(std::uint32_t at, Report& report) const {
    look_for_interrupt();
    const Node& node = nodes_[at];
    if (!node.is_leaf()) {
      return self_pairs(at + 1, report) || self_pairs(node.right, report) ||
             disjoint_pairs(at + 1, node.right, report);
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      for (std::uint32_t j = i + 1; j < node.end; ++j) {
        if (sorted_[i].overlaps(sorted_[j]) && report(items_[i], items_[j])) return true;
      }
    }
    return false;
  }

  /// Of an item of one node and one of another.
  template <class Report>
  bool disjoint_pairs(std::uint32_t first, std::uint32_t second, Report& report) const {
    look_for_interrupt();
    const Node& a = nodes_[first];
    const Node& b = nodes_[second];
    if (!a.box.overlaps(b.box)) return false;
    if (!a.is_leaf() && (b.is_leaf() || a.end - a.begin >= b.end - b.begin)) {
      return disjoint_pairs(first + 1, second, report) || disjoint_pairs(a.right, second, report);
    }
    if (!b.is_leaf()) {
      return disjoint_pairs(first, second + 1, report) || disjoint_pairs(first, b.right, report);
    }
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
      for (std::uint32_t j = b.begin; j < b.end; ++j) {
        if (sorted_[i].overlaps(sorted_[j]) && report(items_[i], items_[j])) return true;
      }
    }
    return false;
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
  std::vector<SpaceBox> sorted_;  ///< boxes in the order of items_
};

}  // namespace minkref::inline space
