// Signs for points with rational coordinates, behind a float filter.
#pragma once

#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/rational.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// A rational point with the nearest doubles.
class FilteredPoint {
 public:
  FilteredPoint() = default;
  explicit FilteredPoint(Point point)
      : exact_(std::move(point)), x_(to_double(exact_.x)), y_(to_double(exact_.y)) {
    look_for_interrupt();
  }
  const Point& exact() const { return exact_; }
  double x() const { return x_; }
  double y() const { return y_; }

 private:
  Point exact_;
  double x_ = 0, y_ = 0;
};

/// The sign of (b - a) x (c - a). Exact.
int orientation(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& c);

/// The sign of (b - a) x (d - c). Exact.
int turn(const FilteredPoint& a, const FilteredPoint& b, const FilteredPoint& c,
         const FilteredPoint& d);

/// The signs of a.x - b.x and a.y - b.y. Exact.
int compare_x(const FilteredPoint& a, const FilteredPoint& b);
int compare_y(const FilteredPoint& a, const FilteredPoint& b);
/// Lexicographic, x first. Exact.
int compare_xy(const FilteredPoint& a, const FilteredPoint& b);
int compare_xy(const Point& a, const Point& b);

}  // namespace minkref::inline plane
