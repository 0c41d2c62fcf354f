// Axis-parallel boxes of doubles, certain enclosures.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace minkref::inline plane {

struct Box {
  static constexpr std::size_t dimensions = 2;
  double xmin = std::numeric_limits<double>::infinity();
  double ymin = std::numeric_limits<double>::infinity();
  double xmax = -std::numeric_limits<double>::infinity();
  double ymax = -std::numeric_limits<double>::infinity();

  /// Closed boxes: boxes that only touch overlap.
  bool overlaps(const Box& other) const {
    return xmin <= other.xmax && other.xmin <= xmax && ymin <= other.ymax && other.ymin <= ymax;
  }
  double centre(std::size_t axis) const {
    return axis == 0 ? xmin / 2 + xmax / 2 : ymin / 2 + ymax / 2;
  }
  void add(const Box& other) {
    xmin = std::min(xmin, other.xmin);
    ymin = std::min(ymin, other.ymin);
    xmax = std::max(xmax, other.xmax);
    ymax = std::max(ymax, other.ymax);
  }
};

/// The next double downwards and upwards: turns a rounded bound into a certain bound. A difference
/// of infinities bounds nothing.
inline double below(double value) {
  if (value == 0) return -std::numeric_limits<double>::denorm_min();
  // Doubles of one sign are ordered as their bits. NaN compares with nothing.
  constexpr double bottom = -std::numeric_limits<double>::infinity();
  if (!(value > bottom)) return bottom;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return std::bit_cast<double>(value > 0 ? bits - 1 : bits + 1);
}
inline double above(double value) { return -below(-value); }

/// The box of s a for a in `box` and low <= s <= high, low > 0; outward rounded.
inline Box scaled(const Box& box, double low, double high) {
  const auto least = [&](double v) { return below(v < 0 ? v * high : v * low); };
  const auto most = [&](double v) { return above(v < 0 ? v * low : v * high); };
  return {least(box.xmin), least(box.ymin), most(box.xmax), most(box.ymax)};
}

/// The box of a + b for a and b in the boxes; outward rounded.
inline Box sum_of(const Box& a, const Box& b) {
  return {below(a.xmin + b.xmin), below(a.ymin + b.ymin), above(a.xmax + b.xmax),
          above(a.ymax + b.ymax)};
}

/// The box of x - q for q of `box` and x of `at`; outward rounded.
inline Box reflected(const Box& box, const Box& at) {
  return {below(at.xmin - box.xmax), below(at.ymin - box.ymax), above(at.xmax - box.xmin),
          above(at.ymax - box.ymin)};
}

}  // namespace minkref::inline plane
