// Axis-parallel boxes in space, in doubles that certainly enclose what they stand for.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "reference/box_tree.hpp"

namespace minkref::inline space {

struct SpaceBox {
  static constexpr std::size_t dimensions = 3;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> least{infinity, infinity, infinity};
  std::array<double, 3> most{-infinity, -infinity, -infinity};

  /// Closed boxes: boxes that only touch overlap.
  bool overlaps(const SpaceBox& other) const {
    return least[0] <= other.most[0] && other.least[0] <= most[0] && least[1] <= other.most[1] &&
           other.least[1] <= most[1] && least[2] <= other.most[2] && other.least[2] <= most[2];
  }
  double centre(std::size_t axis) const { return least[axis] / 2 + most[axis] / 2; }
  void add(const SpaceBox& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], other.least[k]);
      most[k] = std::max(most[k], other.most[k]);
    }
  }
};

using SpaceBoxTree = BasicBoxTree<SpaceBox>;

}  // namespace minkref::inline space
