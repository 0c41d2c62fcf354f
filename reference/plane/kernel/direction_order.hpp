// Directions in the plane in counter-clockwise order, exactly as the kernel's signs allow.
#pragma once

namespace minkref::inline plane {

/// 0 for angles in [-180, 0) degrees, 1 for [0, 180).
template <class K, class V>
int half_turn(const K& kernel, const V& d) {
  const int y = kernel.sign(d.y());
  return y < 0 || (y == 0 && kernel.sign(d.x()) < 0) ? 0 : 1;
}

/// Whether u has a smaller angle than v, both in [-180, 180). False for equal directions.
template <class K, class V>
bool angle_less(const K& kernel, const V& u, const V& v) {
  const int hu = half_turn(kernel, u), hv = half_turn(kernel, v);
  return hu != hv ? hu < hv : kernel.turn(u, v) > 0;
}

/// Whether two parallel directions point the same way.
template <class K, class V>
bool same_way(const K& kernel, const V& u, const V& v) {
  const int ux = kernel.sign(u.x());
  return ux != 0 ? ux == kernel.sign(v.x()) : kernel.sign(u.y()) == kernel.sign(v.y());
}

}  // namespace minkref::inline plane
