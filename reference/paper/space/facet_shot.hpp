// The nearest facet above a point, along a direction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "reference/paper/space/placed_facets.hpp"

namespace minkref::inline space {

/// The least t > 0 for which a facet with use(facet) holds x + t n; nothing if no facet does. A
/// facet along the ray counts from the ray's entry. As exact as T. O(N).
template <class T, class Use>
std::optional<T> first_hit(const PlacedFacets<T>& placed, const typename TwoFacets<T>::Vector& x,
                           const typename TwoFacets<T>::Vector& n, Use&& use) {
  using Vector = typename TwoFacets<T>::Vector;
  std::optional<T> nearest;
  const auto take = [&](T t) {
    if (sign(t) > 0 && (!nearest || sign(T(t - *nearest)) < 0)) nearest = std::move(t);
  };
  for (std::uint32_t facet = 0; facet < placed.facet_count(); ++facet) {
    if (!use(facet)) continue;
    const Vector across = placed.normal(facet);
    const T slope = across.dot(n), height = across.dot(Vector(placed.corner(facet, 0) - x));
    if (sign(slope) != 0) {
      const T t = T(height / slope);
      if (sign(t) <= 0 || (nearest && sign(T(t - *nearest)) >= 0)) continue;
      if (placed.holds(facet, Vector(x + n * t))) take(t);
      continue;
    }
    if (sign(height) != 0) continue;
    T from(0);
    bool enters = true;
    std::optional<T> to;
    for (std::size_t k = 0; enters && k < placed.size(facet); ++k) {
      const Vector& start = placed.corner(facet, k);
      const Vector inwards = across.cross(Vector(placed.corner(facet, k + 1) - start));
      const T rise = inwards.dot(n), inside = inwards.dot(Vector(x - start));
      if (sign(rise) == 0) {
        enters = sign(inside) >= 0;
        continue;
      }
      const T t = T(-inside / rise);
      if (sign(rise) > 0) {
        if (sign(T(t - from)) > 0) from = t;
      } else if (!to || sign(T(t - *to)) < 0) {
        to = t;
      }
    }
    if (enters && (!to || sign(T(*to - from)) >= 0)) take(from);
  }
  return nearest;
}

}  // namespace minkref::inline space
