// Axis-parallel boxes in doubles that certainly enclose what they stand for.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace minkref {

struct Box {
  double xmin = std::numeric_limits<double>::infinity();
  double ymin = std::numeric_limits<double>::infinity();
  double xmax = -std::numeric_limits<double>::infinity();
  double ymax = -std::numeric_limits<double>::infinity();

  /// Closed boxes: boxes that only touch overlap.
  bool overlaps(const Box& other) const {
    return xmin <= other.xmax && other.xmin <= xmax && ymin <= other.ymax && other.ymin <= ymax;
  }
  void add(const Box& other) {
    xmin = std::min(xmin, other.xmin);
    ymin = std::min(ymin, other.ymin);
    xmax = std::max(xmax, other.xmax);
    ymax = std::max(ymax, other.ymax);
  }
};

/// The next double downwards and upwards: what makes a rounded bound a certain one.
inline double below(double value) {
  return std::nextafter(value, -std::numeric_limits<double>::infinity());
}
inline double above(double value) {
  return std::nextafter(value, std::numeric_limits<double>::infinity());
}

/// The box of x - q for q in `box` and x in `at`; outward rounded.
inline Box reflected(const Box& box, const Box& at) {
  return {below(at.xmin - box.xmax), below(at.ymin - box.ymax), above(at.xmax - box.xmin),
          above(at.ymax - box.ymin)};
}

}  // namespace minkref
