// The vertices of a polyhedron over one denominator, and vectors of integers.
#pragma once

#include <array>
#include <vector>

#include "reference/space/polyhedron.hpp"

namespace minkref {

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
inline bool is_zero(const IntegerVector& a) {
  return a[0].is_zero() && a[1].is_zero() && a[2].is_zero();
}

/// The shortest integer vector in the same direction; the zero vector stays.
IntegerVector primitive(const IntegerVector& vector);

/// A vertex is its point over the denominator, the least common one of all coordinates.
struct IntegerPoints {
  Integer denominator = 1;
  std::vector<IntegerVector> points;
};
/// Throws LimitExceeded ("common-denominator-too-long") where it would take more than 100 million
/// bits to write all vertices over it.
IntegerPoints integer_points(const std::vector<SpacePoint>& vertices);

/// Twice the vector area of a closed ring: for a planar one normal to its plane, on the side from
/// which it runs counter-clockwise.
IntegerVector area_vector(const std::vector<IntegerVector>& points, const Face& face);

}  // namespace minkref
