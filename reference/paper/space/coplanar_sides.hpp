// Facets that share a plane at all scales, by the way of the plane (Sec. 5.2, coplanar faces).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "reference/paper/plane/critical_regions.hpp"
#include "reference/paper/space/facet_readings.hpp"
#include "reference/paper/space/two_facets.hpp"

namespace minkref::inline space {

/// The sides of two coplanar facets as moving edges of Sec. 4, projected onto two coordinates.
template <class T>
class CoplanarSides {
 public:
  using Vector = typename TwoFacets<T>::Vector;
  using Edge = MovingEdge<Vector2<T>>;

  /// `zero`: the tolerance below which numbers count as zero. All must outlive it.
  CoplanarSides(const TwoFacets<T>& pair, const FacetReadings& readings, const T& zero)
      : pair_(pair), readings_(readings), zero_(zero) {
    const Vector n = pair.normal(1);
    if (readings.coplanar == FacetReadings::Coplanar::turned) {
      const Vector u = pair.side(1, 0, T(1));
      axes_ = {u, n.cross(u)};
      return;
    }
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(approximate(n[k])) > std::abs(approximate(n[longest]))) longest = k;
    }
    axes_ = {Vector::Unit((longest + 1) % 3), Vector::Unit((longest + 2) % 3)};
  }

  /// The scales at which a side of each meet, from the first to the last, as read. The plane's
  /// readings govern parallel sides, and sides with a common corner.
  std::optional<CriticalRegion<T>> region(std::size_t k, std::size_t l) const {
    if (!readings_.plane.adjacent && share_corner(k, l)) return std::nullopt;
    const Edge a = edge(0, k), b = edge(1, l);
    const PlainKernel<T> kernel;
    if (kernel.turn(a.d, b.d) != 0) {
      return critical_region<T>(PlacedEdge<T>(a), PlacedEdge<T>(b), readings_.plane, zero_);
    }
    if (!readings_.plane.parallel) return std::nullopt;
    return parallel_region(kernel, a, b);
  }

 private:
  Vector2<T> flat(const Vector& v) const { return {T(axes_[0].dot(v)), T(axes_[1].dot(v))}; }

  Edge edge(std::size_t which, std::size_t k) const {
    const auto &from = pair_.named(which, k), &to = pair_.named(which, k + 1);
    const bool is_s = from.of_P != to.of_P;
    const Vector2<T> p = flat(from.p), q = flat(from.q);
    const Vector2<T> end = flat(is_s ? to.p : to.q);
    return {is_s ? ConvolutionEdge::Kind::S : ConvolutionEdge::Kind::T, p, q,
            Vector2<T>(end - (is_s ? p : q))};
  }

  bool share_corner(std::size_t k, std::size_t l) const {
    for (const std::size_t i : {k, k + 1}) {
      for (const std::size_t j : {l, l + 1}) {
        const auto &a = pair_.named(0, i), &b = pair_.named(1, j);
        if (a.of_P == b.of_P && a.of_Q == b.of_Q) return true;
      }
    }
    return false;
  }

  const TwoFacets<T>& pair_;
  const FacetReadings& readings_;
  const T& zero_;
  std::array<Vector, 2> axes_;
};

}  // namespace minkref::inline space
