// Rational vectors in space.
#pragma once

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

inline SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline SpacePoint operator+(const SpacePoint& a, const SpacePoint& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline SpacePoint operator*(const Rational& factor, const SpacePoint& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
inline Rational dot(const SpacePoint& a, const SpacePoint& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline bool is_zero(const SpacePoint& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

}  // namespace minkref::inline space
