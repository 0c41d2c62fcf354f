// A polyhedron's vertices over one denominator, and integer vectors.
#pragma once

#include <array>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

using IntegerVector = std::array<Integer, 3>;

inline IntegerVector operator-(const IntegerVector& a, const IntegerVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline IntegerVector operator+(const IntegerVector& a, const IntegerVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Integer dot(const IntegerVector& a, const IntegerVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The least k with |value| below 2^k.
inline long bits(const Integer& value) {
  return value.is_zero() ? 0 : static_cast<long>(msb(abs(value))) + 1;
}
inline bool is_zero(const IntegerVector& a) {
  return a[0].is_zero() && a[1].is_zero() && a[2].is_zero();
}

/// The first among the axes along which a vector is longest; a view along this axis shows a plane
/// with this normal faithfully.
template <class Vector>
std::size_t longest_axis(const Vector& vector) {
  using Number = typename Vector::value_type;
  const auto magnitude = [&](std::size_t k) {
    return vector[k] < 0 ? Number(-vector[k]) : vector[k];
  };
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (magnitude(k) > magnitude(axis)) axis = k;
  }
  return axis;
}

/// The shortest integer vector in the same direction; the zero vector stays.
IntegerVector primitive(const IntegerVector& vector);

/// The vertices as integer points over the least common denominator of all coordinates.
struct IntegerPoints {
  Integer denominator = 1;
  std::vector<IntegerVector> points;
};
/// Throws LimitExceeded ("common-denominator-too-long") where it would take more than 100 million
/// bits to write all vertices over it.
IntegerPoints integer_points(const std::vector<SpacePoint>& vertices);

}  // namespace minkref::inline space
