// A tree of turned boxes about edges in the plane: pairs that may meet, and edges near a segment.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "reference/near/separation.hpp"

namespace minkref {

/// For edges whose upright boxes overlap far more often than the edges meet: stars, slanted combs.
/// Each node has an upright box and a second one along most of its edges, and is split across the
/// direction with most room beside edges. All in doubles: whatever is left out is certainly apart.
class EdgeTree {
 public:
  using Edge = std::array<std::uint32_t, 2>;  ///< the numbers of both ends; alike for a point

  EdgeTree() = default;
  /// Third coordinates are ignored. O(n log n).
  EdgeTree(std::vector<NearPoint> points, const std::vector<Edge>& edges);

  /// Calls report(i, j), i < j, once for each pair of edges, except for some that are apart.
  /// Near-linear with few close neighbours; O(n^2) at worst. Can be interrupted.
  void pairs(const std::function<void(std::uint32_t, std::uint32_t)>& report) const;

  /// Calls report(i) for each edge, except for some that are farther than `reach` from the segment
  /// from `a` to `b`. Stops when report returns true, and then returns true. Can be interrupted.
  bool near(const NearPoint& a, const NearPoint& b, double reach,
            const std::function<bool(std::uint32_t)>& report) const;

 private:
  static constexpr std::uint32_t leaf_size = 4;
  using Spot = std::array<double, 2>;
  /// A rectangle, inside an upright one.
  struct TurnedBox {
    Spot low, high;
    Spot middle, along;  ///< `along` has length 1
    double half_length, half_width;
  };
  /// An edge's middle, half the way from end to end, and how far its points may be off.
  struct Item {
    Spot middle, half;
    double width;
  };
  struct Node {
    TurnedBox box;
    std::uint32_t begin, end;  ///< in `order_`
    std::uint32_t right;       ///< 0 in a leaf; the left child is the next node
  };
  using PairReport = std::function<void(std::uint32_t, std::uint32_t)>;

  static Item item(const NearPoint& a, const NearPoint& b);
  static bool are_apart(const TurnedBox& a, const TurnedBox& b, double slack);
  NearPoint scaled(const NearPoint& point) const;
  template <class Items>
  static TurnedBox enclosing(const Items& items, double reach);
  void build(std::uint32_t begin, std::uint32_t end);
  Spot best_direction(std::uint32_t begin, std::uint32_t end, const Spot& along) const;
  void within(std::uint32_t at, const PairReport& report) const;
  void between(std::uint32_t first, std::uint32_t second, const PairReport& report) const;
  void report_pair(std::uint32_t i, std::uint32_t j, const PairReport& report) const;
  bool is_leaf(const Node& node) const { return node.right == 0; }

  int exponent_ = 0;  ///< of the power of two that brings coordinates below 2
  std::vector<Item> items_;
  std::vector<std::uint32_t> order_;
  std::vector<TurnedBox> boxes_;  ///< of the items, in this order
  std::vector<Node> nodes_;
};

}  // namespace minkref
