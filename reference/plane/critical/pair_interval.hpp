// The scales at which two convolution edges meet, by the paper's way: over one scalar type, through
// the moving intersection point and a scale for each end point (Behar & Lien 2012, Sec. 4.2).
#pragma once

#include <array>
#include <optional>

#include "reference/plane/critical/line_intersection.hpp"
#include "reference/plane/critical/scale_interval.hpp"
#include "reference/plane/critical/scale_solve.hpp"
#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {

/// x(s) equals an end point u(s) = s p + q iff s alpha = beta, alpha = p - sigma and beta = x0 -
/// sigma - q (Sec. 4.2.1 and 4.2.2). Both are multiples of `direction`.
template <class T>
struct EndCondition {
  Vector2<T> direction, alpha, beta;
};

/// The four conditions as PairEnd orders them. Requires edges that are not parallel.
template <class T>
std::array<EndCondition<T>, 4> end_conditions(const MovingEdge<Vector2<T>>& a,
                                              const MovingEdge<Vector2<T>>& b,
                                              const MovingPoint<T>& x) {
  const auto condition = [&](const MovingEdge<Vector2<T>>& edge,
                             const MovingVertex<Vector2<T>>& end) {
    return EndCondition<T>{edge.d, Vector2<T>(end.p - x.sigma), Vector2<T>(x.x0 - x.sigma - end.q)};
  };
  return {condition(a, start_of(a)), condition(a, end_of(a)), condition(b, start_of(b)),
          condition(b, end_of(b))};
}

template <class T>
std::array<EndCondition<T>, 4> end_conditions(const MovingEdge<Vector2<T>>& a,
                                              const MovingEdge<Vector2<T>>& b) {
  return end_conditions<T>(a, b, line_intersection<T>(a, b));
}

/// Each end point's scale, as PairEnd orders them.
template <class T>
using EndScales = std::array<ScaleSolution<T>, 4>;

template <class T>
EndScales<T> end_scales(const std::array<EndCondition<T>, 4>& conditions, Form form) {
  EndScales<T> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [direction, alpha, beta] = conditions[i];
    result[i] = solve_scale<T, 2>(direction, alpha, beta, form);
  }
  return result;
}

/// A closed interval of scales s > 0, known by its bounds only.
template <class T>
struct BoundedScales {
  bool empty = false;
  std::optional<T> lower, upper;  ///< none: down to 0 (not in it), up to infinity
};

/// [max of the lower ends' scales, min of the upper ends' scales], cut to s > 0. An end point
/// without a root, because the solve is inconsistent or an identity, bounds nothing. A lower bound
/// <= 0 bounds nothing either; an upper bound <= 0 leaves nothing.
template <class T>
BoundedScales<T> between(const EndScales<T>& scales, std::array<PairEnd, 2> lower_ends,
                         std::array<PairEnd, 2> upper_ends) {
  BoundedScales<T> result;
  const auto root = [&](PairEnd end) -> std::optional<T> {
    const ScaleSolution<T>& solution = scales[static_cast<std::size_t>(end)];
    if (solution.kind != Solution::root) return std::nullopt;
    return solution.scale;
  };
  for (const PairEnd end : lower_ends) {
    const auto scale = root(end);
    if (!scale || sign(*scale) <= 0) continue;
    if (!result.lower || sign(T(*scale - *result.lower)) > 0) result.lower = scale;
  }
  for (const PairEnd end : upper_ends) {
    const auto scale = root(end);
    if (!scale) continue;
    if (!result.upper || sign(T(*scale - *result.upper)) < 0) result.upper = scale;
  }
  result.empty = (result.upper && sign(*result.upper) <= 0) ||
                 (result.lower && result.upper && sign(T(*result.lower - *result.upper)) > 0);
  if (result.empty) return {true, {}, {}};
  return result;
}

/// As printed (Sec. 4.2.3): [max{B_a0, B_b0}, min{B_a1, B_b1}]. Right only if the slopes happen to
/// have the signs taken for granted; never for convex P.
template <class T>
BoundedScales<T> printed_interval(const EndScales<T>& scales) {
  return between<T>(scales, {PairEnd::a0, PairEnd::b0}, {PairEnd::a1, PairEnd::b1});
}

/// For convex P only, edges directed counter-clockwise: with c = d_a x d_b,
/// [max{B_a0, B_b1}, min{B_a1, B_b0}] if c > 0, [max{B_a1, B_b0}, min{B_a0, B_b1}] if c < 0.
template <class T>
BoundedScales<T> convex_interval(const EndScales<T>& scales, int turn) {
  if (turn > 0) {
    return between<T>(scales, {PairEnd::a0, PairEnd::b1}, {PairEnd::a1, PairEnd::b0});
  }
  return between<T>(scales, {PairEnd::a1, PairEnd::b0}, {PairEnd::a0, PairEnd::b1});
}

/// As corrected: x(s) does not come before an edge's start iff direction . (beta - s alpha) >= 0
/// for the start, nor beyond its end iff the same <= 0 for the end.
template <class T>
BoundedScales<T> corrected_interval(const std::array<EndCondition<T>, 4>& conditions) {
  std::array<HalfLine<T>, 4> lines;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [direction, alpha, beta] = conditions[i];
    const T slope = direction.dot(alpha), value = direction.dot(beta);
    lines[i] = i % 2 == 0 ? HalfLine<T>{T(-slope), value} : HalfLine<T>{slope, T(-value)};
  }
  const PlainKernel<T> kernel;
  const auto interval = intersection_of_half_lines<PlainKernel<T>>(kernel, lines);
  BoundedScales<T> result{interval.empty, {}, {}};
  if (interval.empty) return result;
  if (interval.lower) result.lower = interval.lower->scale;
  if (interval.upper) result.upper = interval.upper->scale;
  return result;
}

}  // namespace minkref::inline plane
