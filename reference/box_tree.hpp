// A bounding-volume hierarchy over boxes: overlapping pairs, and boxes that meet a given box.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/interrupt.hpp"

namespace minkref {

/// Over closed boxes: `Box{}` is empty, `add` makes it enclose another, `overlaps` tells whether
/// two meet, `centre(axis)` is somewhere about the middle, for each axis below Box::dimensions.
template <class Box>
class BasicBoxTree {
 public:
  BasicBoxTree() = default;
  /// Median splits along the longest side of the centres' extent. O(n log n).
  explicit BasicBoxTree(std::vector<Box> boxes) : items_(boxes.size()), sorted_(std::move(boxes)) {
    std::iota(items_.begin(), items_.end(), 0U);
    if (items_.empty()) return;
    nodes_.reserve(items_.size());
    build(0, static_cast<std::uint32_t>(items_.size()));
    std::vector<Box> ordered(sorted_.size());
    for (std::size_t i = 0; i < items_.size(); ++i) ordered[i] = sorted_[items_[i]];
    sorted_ = std::move(ordered);
  }

  std::size_t size() const { return items_.size(); }
  /// All boxes by number, those near each other in a row.
  const std::vector<std::uint32_t>& order() const { return items_; }

  /// Calls report(i) for every box that overlaps `box`, which report may make smaller meanwhile;
  /// stops early when report returns true, and then returns true.
  template <class Report>
  bool query(const Box& box, Report&& report) const {
    look_for_interrupt();
    return !nodes_.empty() && query_node(0, box, report);
  }

  /// Calls report(i, j), i and j different, once for every pair of boxes that overlap. If report
  /// returns a bool, stops at the first true, and then returns true.
  template <class Report>
  bool pairs(Report&& report) const {
    return !nodes_.empty() && self_pairs(0, report);
  }

  /// Calls report(i, j) for every box i of this tree and j of `other` with overlap(box_i, box_j),
  /// where overlap of leaves must imply overlap of their inner nodes' boxes; stops early when
  /// report returns true.
  template <class Overlap, class Report>
  bool pairs_with(const BasicBoxTree& other, Overlap&& overlap, Report&& report) const {
    return !nodes_.empty() && !other.nodes_.empty() && cross_pairs(0, other, 0, overlap, report);
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Node {
    Box box;
    std::uint32_t begin, end;  ///< items
    std::uint32_t
        right;  ///< index of the right child, 0 for a leaf; the left child is the next node
  };

  /// While building, sorted_ holds the boxes in their original order.
  void build(std::uint32_t begin, std::uint32_t end) {
    look_for_interrupt();
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({Box{}, begin, end, 0});
    Box box;
    for (std::uint32_t i = begin; i < end; ++i) box.add(sorted_[items_[i]]);
    nodes_[at].box = box;
    if (end - begin <= leaf_size) return;
    const std::size_t axis = widest_axis(begin, end);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t j) {
                       return sorted_[i].centre(axis) < sorted_[j].centre(axis);
                     });
    build(begin, middle);
    nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
  }

  std::size_t widest_axis(std::uint32_t begin, std::uint32_t end) const {
    std::size_t widest = 0;
    double most = -1;
    // The last axis wins a tie.
    for (std::size_t axis = 0; axis < Box::dimensions; ++axis) {
      double least = sorted_[items_[begin]].centre(axis), greatest = least;
      for (std::uint32_t i = begin + 1; i < end; ++i) {
        const double centre = sorted_[items_[i]].centre(axis);
        least = std::min(least, centre);
        greatest = std::max(greatest, centre);
      }
      if (greatest - least >= most) {
        most = greatest - least;
        widest = axis;
      }
    }
    return widest;
  }
  bool leaf(const Node& node) const { return node.right == 0; }

  template <class Report>
  bool query_node(std::uint32_t at, const Box& box, Report& report) const {
    const Node& node = nodes_[at];
    if (!node.box.overlaps(box)) return false;
    if (leaf(node)) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (sorted_[i].overlaps(box) && report(items_[i])) return true;
      }
      return false;
    }
    return query_node(at + 1, box, report) || query_node(node.right, box, report);
  }

  template <class Report>
  static bool stops(Report& report, std::uint32_t i, std::uint32_t j) {
    if constexpr (std::is_void_v<std::invoke_result_t<Report&, std::uint32_t, std::uint32_t>>) {
      report(i, j);
      return false;
    } else {
      return report(i, j);
    }
  }

  template <class Report>
  bool self_pairs(std::uint32_t at, Report& report) const {
    look_for_interrupt();
    const Node& node = nodes_[at];
    if (leaf(node)) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        for (std::uint32_t j = i + 1; j < node.end; ++j) {
          if (sorted_[i].overlaps(sorted_[j]) && stops(report, items_[i], items_[j])) return true;
        }
      }
      return false;
    }
    return self_pairs(at + 1, report) || self_pairs(node.right, report) ||
           disjoint_pairs(at + 1, node.right, report);
  }

  template <class Report>
  bool disjoint_pairs(std::uint32_t first, std::uint32_t second, Report& report) const {
    look_for_interrupt();
    const Node& a = nodes_[first];
    const Node& b = nodes_[second];
    if (!a.box.overlaps(b.box)) return false;
    if (leaf(a) && leaf(b)) {
      for (std::uint32_t i = a.begin; i < a.end; ++i) {
        if (!sorted_[i].overlaps(b.box)) continue;
        for (std::uint32_t j = b.begin; j < b.end; ++j) {
          if (sorted_[i].overlaps(sorted_[j]) && stops(report, items_[i], items_[j])) return true;
        }
      }
      return false;
    }
    if (leaf(b) || (!leaf(a) && a.end - a.begin >= b.end - b.begin)) {
      return disjoint_pairs(first + 1, second, report) || disjoint_pairs(a.right, second, report);
    }
    return disjoint_pairs(first, second + 1, report) || disjoint_pairs(first, b.right, report);
  }

  template <class Overlap, class Report>
  bool cross_pairs(std::uint32_t first, const BasicBoxTree& other, std::uint32_t second,
                   Overlap& overlap, Report& report) const {
    look_for_interrupt();
    const Node& a = nodes_[first];
    const Node& b = other.nodes_[second];
    if (!overlap(a.box, b.box)) return false;
    if (leaf(a) && other.leaf(b)) {
      for (std::uint32_t i = a.begin; i < a.end; ++i) {
        for (std::uint32_t j = b.begin; j < b.end; ++j) {
          if (overlap(sorted_[i], other.sorted_[j]) && report(items_[i], other.items_[j])) {
            return true;
          }
        }
      }
      return false;
    }
    if (other.leaf(b) || (!leaf(a) && a.end - a.begin >= b.end - b.begin)) {
      return cross_pairs(first + 1, other, second, overlap, report) ||
             cross_pairs(a.right, other, second, overlap, report);
    }
    return cross_pairs(first, other, second + 1, overlap, report) ||
           cross_pairs(first, other, b.right, overlap, report);
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
  std::vector<Box> sorted_;  ///< boxes in the order of items_
};

}  // namespace minkref
