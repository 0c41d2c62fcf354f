// For which scales two edges of the convolution meet, read off the paper (Behar & Lien 2012,
// Sec. 4.2), each formula as chosen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "reference/plane/critical/pair_interval.hpp"
#include "reference/plane/critical/parallel_pair.hpp"
#include "reference/plane/paper/readings.hpp"

namespace minkref::inline plane {

/// Two edges, the scales s > 0 in which they meet (closed; without a bound down to 0 or up to
/// infinity), and their point of intersection.
template <class T>
struct CriticalRegion {
  std::uint32_t a = 0, b = 0;
  bool parallel = false;  ///< then x is not set
  std::optional<T> lower, upper;
  MovingPoint<T> x{Vector2<T>(T(0), T(0)), Vector2<T>(T(0), T(0))};
};

/// The solve of Sec. 4.2.1 and 4.2.2 as read. `zero`: what counts as zero with a tolerance.
template <class T>
ScaleSolution<T> solve_as_read(const EndCondition<T>& end, const Readings& readings,
                               const T& zero) {
  switch (readings.solve) {
    case Readings::Solve::printed:
      return solve_by_consistency<T, 2>(end.alpha, end.beta);
    case Readings::Solve::tolerance:
      return solve_within<T, 2>(end.alpha, end.beta, zero);
    case Readings::Solve::least_squares:
      return solve_by_least_squares<T, 2>(end.alpha, end.beta);
    case Readings::Solve::corrected:
      break;
  }
  return solve_along<T, 2>(end.direction, end.alpha, end.beta);
}

/// The sign of direction . value; 0 too where a tolerance is given and no coordinate is beyond it.
template <class T>
int sign_along(const Vector2<T>& direction, const Vector2<T>& value, const Readings& readings,
               const T& zero) {
  if (readings.solve == Readings::Solve::tolerance) {
    const auto is_zero = [&](const T& x) {
      return sign(T(x - zero)) <= 0 && sign(T(x + zero)) >= 0;
    };
    if (is_zero(value.x()) && is_zero(value.y())) return 0;
  }
  return sign(T(direction.dot(value)));
}

/// Whether an end point bounds its pair from below; nothing where it does not bound it at all. As
/// printed a start is a lower bound and an end an upper one; in truth the sign of a slope tells.
template <class T>
std::optional<bool> bounds_from_below(const EndCondition<T>& end, bool is_start,
                                      const Readings& readings, const T& zero) {
  if (readings.interval == Form::printed) return is_start;
  const int slope = sign_along<T>(end.direction, end.alpha, readings, zero);
  if (slope == 0) return std::nullopt;
  return (slope < 0) == is_start;
}

/// The region of two edges that are not parallel, as read; nothing where they never meet. Exact if
/// T is and the readings are the corrected ones. Throws UndecidedSign where T cannot tell a sign.
template <class T>
std::optional<CriticalRegion<T>> critical_region(const MovingEdge<Vector2<T>>& a,
                                                 const MovingEdge<Vector2<T>>& b,
                                                 const Readings& readings, const T& zero) {
  CriticalRegion<T> region;
  region.x = line_intersection<T>(a, b, readings.observation);
  const auto ends = end_conditions<T>(a, b, region.x);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const bool is_start = i % 2 == 0;
    const ScaleSolution<T> solution = solve_as_read(ends[i], readings, zero);
    const auto below = bounds_from_below<T>(ends[i], is_start, readings, zero);
    if (solution.kind != Solution::root || !below) {
      if (solution.kind == Solution::inconsistent && readings.no_root == Readings::NoRoot::never) {
        return std::nullopt;
      }
      if (below || readings.interval == Form::printed) continue;  // no solution: it bounds nothing
      // The point keeps its distance from the end: before the edge, on it, or beyond it.
      const int ahead = sign_along<T>(ends[i].direction, ends[i].beta, readings, zero);
      if (is_start ? ahead < 0 : ahead > 0) return std::nullopt;
      continue;
    }
    auto& bound = *below ? region.lower : region.upper;
    const int order = bound ? sign(T(solution.scale - *bound)) : 0;
    if (!bound || (*below ? order > 0 : order < 0)) bound = solution.scale;
  }
  if (region.lower && sign(*region.lower) <= 0) region.lower.reset();
  if (region.upper && sign(*region.upper) <= 0) return std::nullopt;
  if (region.lower && region.upper && sign(T(*region.lower - *region.upper)) > 0) {
    return std::nullopt;
  }
  return region;
}

/// The same of two parallel edges: nothing where they are never on one line, or never meet.
template <class T>
std::optional<CriticalRegion<T>> parallel_region(const PlainKernel<T>& kernel,
                                                 const MovingEdge<Vector2<T>>& a,
                                                 const MovingEdge<Vector2<T>>& b) {
  using Lines = typename ParallelPair<PlainKernel<T>>::Lines;
  const auto pair = parallel_pair(kernel, a, b);
  CriticalRegion<T> region;
  region.parallel = true;
  if (pair.lines == Lines::one_line_at_one_scale && pair.meeting != Meeting::never) {
    region.lower = region.upper = pair.scale;
    return region;
  }
  if (pair.lines != Lines::one_line_always || pair.interval.empty) return std::nullopt;
  if (pair.interval.lower) region.lower = pair.interval.lower->scale;
  if (pair.interval.upper) region.upper = pair.interval.upper->scale;
  return region;
}

}  // namespace minkref::inline plane
