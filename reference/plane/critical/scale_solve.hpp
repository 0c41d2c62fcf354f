// Solving s alpha = beta for the scale (Behar & Lien 2012, Sec. 4.2.1 and 4.2.2).
#pragma once

#include <cmath>

#include "reference/form.hpp"
#include "reference/number/eigen.hpp"
#include "reference/number/scalar.hpp"

namespace minkref::inline plane {

enum class Solution {
  root,          ///< one scale
  inconsistent,  ///< none
  identity,      ///< every scale
};

template <class T>
struct ScaleSolution {
  Solution kind = Solution::inconsistent;
  T scale = T(0);  ///< where `kind` is root; of any sign
};

template <class T, int D>
using ScaleVector = Eigen::Matrix<T, D, 1>;

/// As printed: D equations for one unknown, "no solution for s if the system is inconsistent". The
/// largest component of alpha gives s, the others must agree, by equality of T. Under rounding
/// arithmetic they seldom do. Throws UndecidedSign where T cannot tell.
template <class T, int D>
ScaleSolution<T> solve_by_consistency(const ScaleVector<T, D>& alpha,
                                      const ScaleVector<T, D>& beta) {
  int pivot = 0;
  for (int i = 1; i < D; ++i) {
    if (std::abs(approximate(alpha[i])) > std::abs(approximate(alpha[pivot]))) pivot = i;
  }
  if (sign(alpha[pivot]) == 0) {
    for (int i = 0; i < D; ++i) {
      if (sign(alpha[i]) != 0 || sign(beta[i]) != 0) return {};
    }
    return {Solution::identity, T(0)};
  }
  const T scale = T(beta[pivot] / alpha[pivot]);
  for (int i = 0; i < D; ++i) {
    if (i != pivot && sign(T(scale * alpha[i] - beta[i])) != 0) return {};
  }
  return {Solution::root, scale};
}

/// As corrected: alpha and beta are multiples of `direction` (from the end point's edge), so the
/// system reduces to the equation s (direction . alpha) = direction . beta.
template <class T, int D>
ScaleSolution<T> solve_along(const ScaleVector<T, D>& direction, const ScaleVector<T, D>& alpha,
                             const ScaleVector<T, D>& beta) {
  const T slope = direction.dot(alpha), value = direction.dot(beta);
  if (sign(slope) != 0) return {Solution::root, T(value / slope)};
  return {sign(value) == 0 ? Solution::identity : Solution::inconsistent, T(0)};
}

/// Solves the overdetermined system by least squares: s = (alpha . beta) / (alpha . alpha). Never
/// inconsistent, unless alpha is zero.
template <class T, int D>
ScaleSolution<T> solve_by_least_squares(const ScaleVector<T, D>& alpha,
                                        const ScaleVector<T, D>& beta) {
  const T square = alpha.dot(alpha);
  if (sign(square) != 0) return {Solution::root, T(T(alpha.dot(beta)) / square)};
  return {sign(T(beta.dot(beta))) == 0 ? Solution::identity : Solution::inconsistent, T(0)};
}

/// Solves the system with a tolerance: numbers up to `tolerance` count as zero.
template <class T, int D>
ScaleSolution<T> solve_within(const ScaleVector<T, D>& alpha, const ScaleVector<T, D>& beta,
                              const T& tolerance) {
  const auto is_zero = [&](const T& value) {
    return sign(T(value - tolerance)) <= 0 && sign(T(value + tolerance)) >= 0;
  };
  int pivot = 0;
  for (int i = 1; i < D; ++i) {
    if (std::abs(approximate(alpha[i])) > std::abs(approximate(alpha[pivot]))) pivot = i;
  }
  if (is_zero(alpha[pivot])) {
    for (int i = 0; i < D; ++i) {
      if (!is_zero(alpha[i]) || !is_zero(beta[i])) return {};
    }
    return {Solution::identity, T(0)};
  }
  const T scale = T(beta[pivot] / alpha[pivot]);
  for (int i = 0; i < D; ++i) {
    if (i != pivot && !is_zero(T(scale * alpha[i] - beta[i]))) return {};
  }
  return {Solution::root, scale};
}

template <class T, int D>
ScaleSolution<T> solve_scale(const ScaleVector<T, D>& direction, const ScaleVector<T, D>& alpha,
                             const ScaleVector<T, D>& beta, Form form) {
  return form == Form::printed ? solve_by_consistency<T, D>(alpha, beta)
                               : solve_along<T, D>(direction, alpha, beta);
}

}  // namespace minkref::inline plane
