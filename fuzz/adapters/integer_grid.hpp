// Doubles to an integer grid and back.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fuzz/adapters/adapter_protocol.hpp"

namespace minkref::adapter {

/// The largest absolute value.
inline double largest_coordinate(const Polygons& polygons) {
  double largest = 0;
  for (const Ring& ring : rings_of(polygons)) {
    for (const Point& p : ring) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  return largest;
}

/// A grid with a power of two as its unit, chosen for each call so that the sum's coordinates
/// (largest of sP plus largest of Q) lie between 2^(bits-1) and 2^bits units. So n units make at
/// most n 2^(1-bits) times this size: the relative tolerance that an adapter declares. Numbers with
/// few enough digits are not rounded at all.
class IntegerGrid {
 public:
  IntegerGrid(const Polygons& sP, const Polygons& Q, int bits)
      : IntegerGrid(largest_coordinate(sP) + largest_coordinate(Q), bits) {}

  /// For results with coordinates up to `size`.
  IntegerGrid(double size, int bits) {
    if (!std::isfinite(size)) throw Skipped("the coordinates of the sum exceed the doubles");
    int exponent = 0;  // size < 2^exponent
    if (size > 0) std::frexp(size, &exponent);
    shift_ = bits - exponent;
  }

  std::int64_t to_grid(double value) const { return std::llround(std::ldexp(value, shift_)); }
  double scaled(double length) const { return std::ldexp(length, shift_); }
  double from_grid(std::int64_t value) const {
    return std::ldexp(static_cast<double>(value), -shift_);
  }

 private:
  int shift_ = 0;
};

}  // namespace minkref::adapter
