// For which scales two edges of the convolution meet, read off the paper (Behar & Lien 2012,
// Sec. 4.2), each formula as chosen.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "reference/paper/plane/readings.hpp"
#include "reference/plane/critical/pair_interval.hpp"
#include "reference/plane/critical/parallel_pair.hpp"

namespace minkref::inline plane {

/// Two edges, the scales s > 0 at which they meet (closed; without a bound down to 0 or up to
/// infinity), and their point of intersection.
template <class T>
struct CriticalRegion {
  std::uint32_t a = 0, b = 0;
  bool parallel = false;  ///< then x is not set
  std::optional<T> lower, upper;
  MovingPoint<T> x{Vector2<T>(T(0), T(0)), Vector2<T>(T(0), T(0))};
};

/// An edge's values that the formulas need again with each other edge, computed once.
template <class T>
struct PlacedEdge {
  explicit PlacedEdge(const MovingEdge<Vector2<T>>& edge)
      : is_s(edge.is_s()),
        direction(edge.d),
        ends{start_of(edge), end_of(edge)},
        lines(edge_lines(edge)) {}

  bool is_s;
  Vector2<T> direction;
  std::array<MovingVertex<Vector2<T>>, 2> ends;
  EdgeLines<T> lines;
};

namespace detail {

/// s alpha = beta for an end point (Sec. 4.2.1 and 4.2.2), and both along the edge's direction.
template <class T>
struct EndEquation {
  /// Both ends of an edge share alpha or beta: the second end computes only the other vector.
  void set(const PlacedEdge<T>& edge, bool is_start, const MovingPoint<T>& x,
           const Vector2<T>& x0_less_sigma) {
    const auto& [p, q] = edge.ends[is_start ? 0 : 1];
    if (is_start || edge.is_s) {
      alpha = Vector2<T>(T(p.x() - x.sigma.x()), T(p.y() - x.sigma.y()));
      slope = PlainKernel<T>::dot(edge.direction, alpha);
    }
    if (is_start || !edge.is_s) {
      beta = Vector2<T>(T(x0_less_sigma.x() - q.x()), T(x0_less_sigma.y() - q.y()));
      value = PlainKernel<T>::dot(edge.direction, beta);
    }
  }

  Vector2<T> alpha, beta;
  T slope{}, value{};
};

/// The bounds of two edges, end point by end point.
template <class T>
class RegionBounds {
 public:
  /// `zero`: the tolerance below which numbers count as zero. `finite`: no later number is NaN.
  RegionBounds(const Readings& readings, const T& zero, bool finite)
      : readings_(readings), zero_(zero), finite_(finite) {}

  /// Whether the edges may still meet. With finite numbers the test ends once nothing is left, and
  /// does not divide where the root's sign is enough: the answer is the same.
  bool take(const EndEquation<T>& end, bool is_start) {
    const ScaleSolution<T> solution = solve(end);
    const auto below = bounds_from_below(end, is_start);
    if (solution.kind != Solution::root || !below) {
      if (solution.kind == Solution::inconsistent && readings_.no_root == Readings::NoRoot::never) {
        return false;
      }
      if (below || readings_.interval == Form::printed) return true;  // it bounds nothing
      // The point keeps its distance from the end: before the edge, on it, or beyond.
      const int ahead = sign_of(end.beta, end.value);
      return is_start ? ahead >= 0 : ahead <= 0;
    }
    if (finite_ && readings_.solve == Readings::Solve::corrected) {
      if (sign(end.value) * sign(end.slope) <= 0) return *below;
      return tighten(T(end.value / end.slope), *below);
    }
    return tighten(solution.scale, *below);
  }

  /// Cuts the bounds to s > 0; false if nothing is left.
  bool finish() {
    if (lower && sign(*lower) <= 0) lower.reset();
    if (upper && sign(*upper) <= 0) return false;
    return !lower || !upper || sign(T(*lower - *upper)) <= 0;
  }

  std::optional<T> lower, upper;

 private:
  ScaleSolution<T> solve(const EndEquation<T>& end) const {
    switch (readings_.solve) {
      case Readings::Solve::printed:
        return solve_by_consistency<T, 2>(end.alpha, end.beta);
      case Readings::Solve::tolerance:
        return solve_within<T, 2>(end.alpha, end.beta, zero_);
      case Readings::Solve::least_squares:
        return solve_by_least_squares<T, 2>(end.alpha, end.beta);
      case Readings::Solve::corrected:
        break;
    }
    if (sign(end.slope) == 0) {
      return {sign(end.value) == 0 ? Solution::identity : Solution::inconsistent, T(0)};
    }
    return {Solution::root, finite_ ? T(0) : T(end.value / end.slope)};
  }

  /// Whether an end point bounds its pair from below; nothing if it gives no bound at all. As
  /// printed, a start is a lower bound and an end an upper bound; the truth depends on the sign of
  /// a slope.
  std::optional<bool> bounds_from_below(const EndEquation<T>& end, bool is_start) const {
    if (readings_.interval == Form::printed) return is_start;
    const int slope = sign_of(end.alpha, end.slope);
    if (slope == 0) return std::nullopt;
    return (slope < 0) == is_start;
  }

  /// The sign of a vector along the direction; with a tolerance also 0 if no coordinate exceeds it.
  int sign_of(const Vector2<T>& vector, const T& along) const {
    if (readings_.solve == Readings::Solve::tolerance) {
      const auto is_zero = [&](const T& x) {
        return sign(T(x - zero_)) <= 0 && sign(T(x + zero_)) >= 0;
      };
      if (is_zero(vector.x()) && is_zero(vector.y())) return 0;
    }
    return sign(along);
  }

  bool tighten(T scale, bool below) {
    auto& bound = below ? lower : upper;
    const int order = bound ? sign(T(scale - *bound)) : 0;
    if (bound && (below ? order <= 0 : order >= 0)) return true;
    bound = std::move(scale);
    if (!finite_) return true;
    if (upper && sign(*upper) <= 0) return false;
    return !lower || !upper || sign(T(*lower - *upper)) <= 0;
  }

  const Readings& readings_;
  const T& zero_;
  const bool finite_;
};

/// Whether sums, products and quotients of these numbers, and of others as large, are finite.
template <class T>
bool stays_finite(const MovingPoint<T>& x) {
  if constexpr (std::is_same_v<T, Rational>) return true;
  if constexpr (std::is_same_v<T, Mpfr>) {  // with exponents of 62 bits
    return is_finite(x.x0.x()) && is_finite(x.x0.y()) && is_finite(x.sigma.x()) &&
           is_finite(x.sigma.y());
  }
  return false;
}

}  // namespace detail

/// The region of two edges that are not parallel, as read; nothing if they never meet. Exact if T
/// is exact and the readings are corrected. `zero`: the tolerance below which numbers count as
/// zero. Throws UndecidedSign where T cannot tell a sign.
template <class T>
std::optional<CriticalRegion<T>> critical_region(const PlacedEdge<T>& a, const PlacedEdge<T>& b,
                                                 const Readings& readings, const T& zero) {
  const MovingPoint<T> x = line_intersection<T>(a.lines, b.lines, readings.observation);
  const Vector2<T> x0_less_sigma(x.x0 - x.sigma);
  detail::RegionBounds<T> bounds(readings, zero, detail::stays_finite(x));
  detail::EndEquation<T> end;
  for (const PlacedEdge<T>* edge : {&a, &b}) {
    for (const bool is_start : {true, false}) {
      end.set(*edge, is_start, x, x0_less_sigma);
      if (!bounds.take(end, is_start)) return std::nullopt;
    }
  }
  if (!bounds.finish()) return std::nullopt;
  CriticalRegion<T> region;
  region.lower = std::move(bounds.lower);
  region.upper = std::move(bounds.upper);
  region.x = x;
  return region;
}

/// The region of two parallel edges: nothing if they never share a line, or never meet.
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
