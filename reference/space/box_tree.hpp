// Axis-parallel boxes in space, and the bounding-volume hierarchy over them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "reference/box_tree.hpp"

namespace minkref::inline space {

/// A box with double bounds that certainly encloses the object. Boxes are closed: touching boxes
/// overlap. A new box encloses nothing.
struct SpaceBox {
  static constexpr std::size_t dimensions = 3;
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
  /// The middle along an axis; 0 for an interval unbounded both ways.
  double centre(std::size_t axis) const {
    const double middle = low[axis] / 2 + high[axis] / 2;
    return std::isnan(middle) ? 0 : middle;
  }
};

using SpaceBoxTree = BasicBoxTree<SpaceBox>;

}  // namespace minkref::inline space
