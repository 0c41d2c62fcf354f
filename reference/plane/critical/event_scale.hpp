// An event's scale, from its pair of edges.
#pragma once

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/critical/parallel_pair.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref::inline plane {

/// A scale of a kernel as a number.
inline Rational exact_parameter(const PlainKernel<Rational>&, const Rational& t) { return t; }
template <class Grid>
Rational exact_parameter(const GridKernel<Grid>&, const typename GridKernel<Grid>::Parameter& t) {
  return GridKernel<Grid>::exact(t);
}

/// As exact as the kernel.
template <class K>
typename K::Parameter event_scale(const K& kernel, const MovingEdge<typename K::Vector>& a,
                                  const MovingEdge<typename K::Vector>& b, const PairEvent& event) {
  if (!event.parallel) {
    return root_of(kernel, pair_conditions(kernel, a, b).half_lines[event.half_line]);
  }
  const ParallelPair<K> pair = parallel_pair(kernel, a, b);
  if (pair.lines == ParallelPair<K>::Lines::one_line_at_one_scale) return pair.scale;
  return event.change == Change::death ? pair.interval.upper->scale : pair.interval.lower->scale;
}

}  // namespace minkref::inline plane
