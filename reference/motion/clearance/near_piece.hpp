// Scales at which a vertex or an edge of a moving part is nearer to a feature of the obstacles than
// some distance: one interval, by a quadratic and linear conditions.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "reference/motion/valid_scales.hpp"
#include "reference/number/interval.hpp"
#include "reference/number/radicals/root_order.hpp"

namespace minkref::inline motion {

template <class N>
struct Pair {
  N x, y;

  friend Pair operator-(const Pair& a, const Pair& b) { return {a.x - b.x, a.y - b.y}; }
  friend N dot(const Pair& a, const Pair& b) { return a.x * b.x + a.y * b.y; }
  friend N cross(const Pair& a, const Pair& b) { return a.x * b.y - a.y * b.x; }
};

/// Scales s with (slope s - level)² < squared_width, and so[k] s >= least[k].
template <class N>
struct NearCondition {
  N slope, level, squared_width;
  struct Side {
    N factor, least;  ///< factor s >= least
  };
  std::vector<Side> sides;
};

/// Where s a is nearer to the point v than c: |s a - v|² < c², as a square completed. `is_origin`:
/// a is zero.
template <class N>
NearCondition<N> near_point(const Pair<N>& a, const Pair<N>& v, const N& squared_clearance,
                            bool is_origin) {
  if (is_origin) return {N(0), N(0), squared_clearance - dot(v, v), {}};
  // |a|² times the condition: (|a|² s - a·v)² < |a|² c² - (a × v)².
  const N turn = cross(a, v), length = dot(a, a);
  return {length, dot(a, v), length * squared_clearance - turn * turn, {}};
}

/// Where s a lies in front of the segment from p along d, nearer to its line than c.
template <class N>
NearCondition<N> near_segment(const Pair<N>& a, const Pair<N>& p, const Pair<N>& d,
                              const N& squared_clearance) {
  const N length = dot(d, d), along = dot(d, a), start = dot(d, p);
  return {cross(d, a),
          cross(d, p),
          squared_clearance * length,
          {{along, start}, {N(0) - along, N(0) - start - length}}};
}

/// Where the point b lies in front of the segment s [a, a + d], nearer to its line than c.
template <class N>
NearCondition<N> near_moving_segment(const Pair<N>& b, const Pair<N>& a, const Pair<N>& d,
                                     const N& squared_clearance) {
  const N length = dot(d, d), along = dot(d, a), foot = dot(d, b);
  return {cross(d, a),
          cross(d, b),
          squared_clearance * length,
          {{N(0) - along, N(0) - foot}, {along + length, foot}}};
}

}  // namespace minkref::inline motion
