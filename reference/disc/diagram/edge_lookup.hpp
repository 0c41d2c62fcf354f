// The edges of P by places, and the vertices that lie on edges of others.
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
  /// `curves` must outlive it. O(n log n) for rings that touch in few places.
  explicit EdgeLookup(const OffsetCurves& curves);

  const OffsetCurves& curves() const { return curves_; }
  const plane::BoxTree& tree() const { return tree_; }
  const EdgeNumbers<Interval>& edge(std::uint32_t number) const { return edges_[number]; }
  /// The longer side of the box around all.
  double size() const { return size_; }

  /// Whether a vertex is inside of an edge of a line, or where one edge of it goes on as another.
  bool is_within(std::uint32_t line, std::uint32_t vertex) const {
    return within_.contains({line, vertex});
  }
  /// Edges and the vertices inside of them.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& touched() const { return touched_; }

 private:
  const OffsetCurves& curves_;
  std::vector<EdgeNumbers<Interval>> edges_;
  plane::BoxTree tree_;
  double size_ = 0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> within_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touched_;
};

}  // namespace minkref::inline disc
