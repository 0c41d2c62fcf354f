// The edges of P by place, and the vertices that lie on other edges.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "reference/disc/curves/patch_numbers.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline disc {

/// Exact, but for the boxes, which certainly hold the edges.
class EdgeLookup {
 public:
  /// `curves` must outlive the lookup. O(n log n) for rings that touch at few places.
  explicit EdgeLookup(const OffsetCurves& curves);

  const OffsetCurves& curves() const { return curves_; }
  const plane::BoxTree& tree() const { return tree_; }
  const EdgeNumbers<Interval>& edge(std::uint32_t number) const { return edges_[number]; }
  /// The box around all.
  const plane::Box& around() const { return around_; }
  /// Its longer side.
  double size() const { return size_; }

  /// Whether a vertex lies inside an edge of a line, or where one edge of the line goes on as
  /// another.
  bool is_within(std::uint32_t line, std::uint32_t vertex) const {
    return within_.contains({line, vertex});
  }
  /// Edges, with the vertices inside them.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& touched() const { return touched_; }

 private:
  const OffsetCurves& curves_;
  std::vector<EdgeNumbers<Interval>> edges_;
  plane::BoxTree tree_;
  plane::Box around_;
  double size_ = 0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> within_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touched_;
};

}  // namespace minkref::inline disc
