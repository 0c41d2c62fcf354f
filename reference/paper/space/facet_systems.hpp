// Systems for the scale from Sec. 5.1 and 5.2, each solved as read.
#pragma once

#include <cstddef>

#include "reference/paper/space/facet_readings.hpp"
#include "reference/paper/space/two_facets.hpp"
#include "reference/plane/critical/scale_solve.hpp"

namespace minkref::inline space {

/// Scales at which a facet's corner or side meets a second facet's plane or side.
/// Throws UndecidedSign where T cannot tell.
template <class T>
class FacetSystems {
 public:
  using Pair = TwoFacets<T>;
  using Vector = typename Pair::Vector;
  using Track = typename Pair::Track;

  /// `zero`: the tolerance below which numbers count as zero. All must outlive it.
  FacetSystems(const Pair& pair, const FacetReadings& readings, const T& zero)
      : pair_(pair), readings_(readings), zero_(zero) {}

  /// x(s) = e(s) for a corner at the end of a side, whose line meets the other plane in x (5.1).
  ScaleSolution<T> corner_on_track(std::size_t which, std::size_t side, std::size_t corner,
                                   const Track& x) const {
    const auto& own = pair_.named(which, corner);
    return solve(pair_.side(which, side, T(1)), own.p - x.sigma, x.x0 - x.sigma - own.q);
  }

  /// The scale at which the corner itself is on the other facet's plane.
  ScaleSolution<T> corner_on_plane(std::size_t which, std::size_t corner) const {
    const auto &own = pair_.named(which, corner), &ta = pair_.named(1 - which, 0);
    const Vector n = pair_.normal(1 - which);
    return level(n.dot(Vector(own.p - ta.p)), n.dot(Vector(ta.q - own.q)));
  }

  /// x1(s) = x2(s) (5.2).
  ScaleSolution<T> points_meet(const Track& x1, const Track& x2) const {
    const Vector alpha = x1.sigma - x2.sigma,
                 beta = Vector(x2.x0 - x2.sigma) - Vector(x1.x0 - x1.sigma);
    return solve(pair_.normal(0).cross(pair_.normal(1)), alpha, beta);
  }

  /// The determinant of both sides and the way between them is zero: linear in s.
  ScaleSolution<T> lines_meet(std::size_t k, std::size_t l) const {
    const auto &a = pair_.named(0, k), &b = pair_.named(1, l);
    const Vector u = pair_.side(0, k, T(1)), v = pair_.side(1, l, T(1));
    const auto volume = [&](const Vector& way) {
      typename Pair::Matrix columns;
      columns << u, v, way;
      return T(columns.determinant());
    };
    return level(volume(b.p - a.p), volume(a.q - b.q));
  }

 private:
  /// s alpha = beta as read, both multiples of `direction`.
  ScaleSolution<T> solve(const Vector& direction, const Vector& alpha, const Vector& beta) const {
    switch (readings_.solve) {
      case Readings::Solve::printed:
        return solve_by_consistency<T, 3>(alpha, beta);
      case Readings::Solve::tolerance:
        return solve_within<T, 3>(alpha, beta, zero_);
      case Readings::Solve::least_squares:
        return solve_by_least_squares<T, 3>(alpha, beta);
      case Readings::Solve::corrected:
        break;
    }
    return solve_along<T, 3>(direction, alpha, beta);
  }

  /// The scale at which s slope = value.
  static ScaleSolution<T> level(const T& slope, const T& value) {
    if (sign(slope) != 0) return {Solution::root, T(value / slope)};
    return {sign(value) == 0 ? Solution::identity : Solution::inconsistent, T(0)};
  }

  const Pair& pair_;
  const FacetReadings& readings_;
  const T& zero_;
};

}  // namespace minkref::inline space
