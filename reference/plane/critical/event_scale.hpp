// The scale of an event, from its pair of edges.
#pragma once

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/critical/parallel_pair.hpp"

namespace minkref {

/// Exact as the kernel is.
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

}  // namespace minkref
