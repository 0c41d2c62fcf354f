// Pairs of triangles or edges that may have more in common than a corner.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "reference/near/separation.hpp"

namespace minkref {

/// A triangle, or an edge, which has one of its ends twice: its corners by their numbers.
struct NearItem {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t group;  ///< items of one group stand together, and are no pair
};

/// A tree of clusters. First the fans about points in many groups are told apart, else two clusters
/// would share the middles of two fans; then groups; then items. Each time the split is across the
/// direction in which there is most room for them beside each other: slivers are sorted across.
class NearPairs {
 public:
  /// Points of one number count as one. Items of one group stand next to each other.
  /// O(n log^2 n).
  NearPairs(std::vector<NearPoint> points, std::vector<NearItem> items);

  /// Calls report(i, j), i < j, once for each pair of items of different groups, except for some
  /// that are apart but for one corner that both have. Near-linear where few clusters touch each
  /// other in more than a point; O(n^2) at worst. Can be interrupted.
  void pairs(const std::function<void(std::uint32_t, std::uint32_t)>& report) const;

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Extent {
    NearVector low, high;
  };
  struct Node {
    std::uint32_t begin = 0, end = 0;    ///< in `order_`
    std::uint32_t right = 0;             ///< 0 in a leaf; the left child is the next node
    std::optional<std::uint32_t> group;  ///< where all items have the same
    Extent box{};
    Cluster points;
  };
  using Report = std::function<void(std::uint32_t, std::uint32_t)>;

  using Units = std::vector<std::vector<std::uint32_t>>;

  void scale_to_unit();
  void find_fans();
  void build(std::uint32_t begin, std::uint32_t end);
  void enclose(Node& node) const;
  /// The fans in order_[begin, end), or the groups of a single one, or the items of one group.
  Units units_in(std::uint32_t begin, std::uint32_t end) const;
  std::uint32_t split(std::uint32_t begin, std::uint32_t end);
  NearVector best_direction(const Units& units) const;
  double position(std::uint32_t item, const NearVector& along) const;
  void within(std::uint32_t at, const Report& report) const;
  void between(std::uint32_t first, std::uint32_t second, const Report& report) const;
  void report_pair(std::uint32_t i, std::uint32_t j, const Report& report) const;
  bool is_leaf(const Node& node) const { return node.right == 0; }

  std::vector<NearPoint> points_;
  std::vector<NearItem> items_;
  std::vector<std::uint32_t> fan_;  ///< of each item
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace minkref
