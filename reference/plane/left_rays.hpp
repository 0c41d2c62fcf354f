// Rays to the left: the edge that each meets first.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reference/no_entry.hpp"
#include "reference/plane/arrangement/ray_tree.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {

/// Edges that share ends at most, or touch, and do not cross. Exact. Many rays: O(log n) each where
/// few boxes of edges overlap, O(n) at worst.
class LeftRays {
 public:
  struct Edge {
    const FilteredPoint* from;
    const FilteredPoint* to;
  };
  struct Hit {
    std::uint32_t edge = no_entry;  ///< none: `no_entry`
    bool touches = false;           ///< whether the point lies on an edge that counts
  };

  /// Keeps pointers to the points.
  explicit LeftRays(std::vector<Edge> edges) : edges_(std::move(edges)) {}

  /// The edge that a ray to the left, just above the point, meets first, among those for which
  /// `counts` holds. Edges through the point itself are not met.
  Hit first(const FilteredPoint& point, const std::function<bool(std::uint32_t)>& counts);

 private:
  const FilteredPoint& low(std::uint32_t e) const;
  const FilteredPoint& high(std::uint32_t e) const;
  bool is_right_of(std::uint32_t g, std::uint32_t h) const;
  bool touches(std::uint32_t e, const FilteredPoint& point) const;
  bool passes_left_of(std::uint32_t e, const FilteredPoint& point) const;
  void grow_tree();

  static constexpr unsigned rays_before_a_tree = 17;  ///< fewer cost less than the tree
  std::vector<Edge> edges_;
  unsigned asked_ = 0;
  RayTree tree_;
};

}  // namespace minkref::inline plane
