// Collision detection between P and a disc (Behar & Lien 2012, Sec. 3).
#pragma once

#include <vector>

#include "reference/paper/disc/moving_feature.hpp"

namespace minkref::inline disc {

/// Whether P meets the disc about x with the squared radius `square`: x is in P, or at most a
/// radius away from an edge. As exact as T. O(n).
template <class T>
bool meets_disc(const std::vector<MovingFeature<T>>& features, const T& square,
                const Vector<T>& x) {
  bool is_in_P = false;
  for (const MovingFeature<T>& edge : features) {
    if (edge.is_arc) continue;
    const Vector<T> from = x - edge.corner[0], to = x - edge.corner[1];
    const T part = dot(edge.along, from), length = dot(edge.along, edge.along),
            across = cross(edge.along, from);
    if (sign(part) <= 0) {
      if (order_of(T(dot(from, from)), square) <= 0) return true;
    } else if (order_of(part, length) >= 0) {
      if (order_of(T(dot(to, to)), square) <= 0) return true;
    } else if (order_of(T(across * across), T(square * length)) <= 0) {
      return true;
    }
    const bool starts_above = sign(from.y) < 0, ends_above = sign(to.y) < 0;
    if (starts_above != ends_above && (sign(across) > 0) == ends_above) is_in_P = !is_in_P;
  }
  return is_in_P;
}

}  // namespace minkref::inline disc
