// Moving boxes: their hierarchy finds the things that may meet at some scale within a window.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "reference/box_tree.hpp"

namespace minkref {

/// A box around points moving along lines, from one end of a window of scales to the other. Between
/// the ends each side moves evenly, since the least of evenly moving numbers does not fall below
/// the line between its end values. `Box` has its least and greatest coordinates as arrays.
template <class Box>
struct BasicMovingBox {
  static constexpr std::size_t axes = Box::dimensions, dimensions = 2 * axes;
  Box at_first, at_last;

  void add(const BasicMovingBox& other) {
    at_first.add(other.at_first);
    at_last.add(other.at_last);
  }
  double centre(std::size_t axis) const {
    return axis < axes ? at_first.centre(axis) : at_last.centre(axis - axes);
  }

  /// Whether boxes overlap at some scale within the window. True also if rounding leaves the answer
  /// open.
  bool overlaps(const BasicMovingBox& other) const {
    double from = 0, to = 1;  // of the way through the window
    for (std::size_t k = 0; k < axes; ++k) {
      if (!stays_below(at_first.low[k], at_last.low[k], other.at_first.high[k],
                       other.at_last.high[k], from, to) ||
          !stays_below(other.at_first.low[k], other.at_last.low[k], at_first.high[k],
                       at_last.high[k], from, to)) {
        return false;
      }
    }
    return true;
  }

 private:
  /// Shortens the way to the part where one number does not exceed another.
  static bool stays_below(double first, double last, double other_first, double other_last,
                          double& from, double& to) {
    constexpr double slack = 0x1p-50, way_slack = 0x1p-30;
    const double before = other_first - first + slack * (std::abs(first) + std::abs(other_first)),
                 after = other_last - last + slack * (std::abs(last) + std::abs(other_last));
    if (before < 0 && after < 0) return false;
    if (before < 0) from = std::max(from, before / (before - after) - way_slack);
    if (after < 0) to = std::min(to, before / (before - after) + way_slack);
    return !(from > to);
  }
};

}  // namespace minkref
