// Two parallel convolution edges: never on one line, at one scale, or at all scales.
#pragma once

#include <array>

#include "reference/plane/critical/scale_interval.hpp"

namespace minkref::inline plane {

enum class Meeting { never, touching, overlapping };

template <class K>
struct ParallelPair {
  enum class Lines { apart, one_line_at_one_scale, one_line_always } lines = Lines::apart;
  typename K::Parameter scale{};     ///< of one_line_at_one_scale; positive
  Meeting meeting = Meeting::never;  ///< at that scale
  ScaleInterval<K> interval;         ///< of one_line_always: where the edges meet
};

namespace detail {

/// Along d_a, from a0: a spans [0, a_length], b spans [b_from, b_to], each linear in s.
template <class W>
struct ParallelSpans {
  HalfLine<W> a_length, b_from, b_to;
};

template <class K>
ParallelSpans<typename K::Wide> parallel_spans(const K& kernel,
                                               const MovingEdge<typename K::Vector>& a,
                                               const MovingEdge<typename K::Vector>& b) {
  using W = typename K::Wide;
  const typename K::Vector p(b.p - a.p), q(b.q - a.q);
  const W own = K::dot(a.d, a.d), other = K::dot(a.d, b.d);
  const HalfLine<W> start{K::dot(p, a.d), K::dot(q, a.d)};
  const HalfLine<W> end = b.is_s() ? HalfLine<W>{W(start.slope + other), start.value}
                                   : HalfLine<W>{start.slope, W(start.value + other)};
  const HalfLine<W> length = a.is_s() ? HalfLine<W>{own, W(0)} : HalfLine<W>{W(0), own};
  if (kernel.sign(other) < 0) return {length, end, start};
  return {length, start, end};
}

}  // namespace detail

/// Requires d_a x d_b = 0. As exact as the kernel's signs.
template <class K>
ParallelPair<K> parallel_pair(const K& kernel, const MovingEdge<typename K::Vector>& a,
                              const MovingEdge<typename K::Vector>& b) {
  using W = typename K::Wide;
  using Lines = typename ParallelPair<K>::Lines;
  ParallelPair<K> result;
  const HalfLine<W> distance{K::cross(a.d, typename K::Vector(b.p - a.p)),
                             K::cross(a.d, typename K::Vector(b.q - a.q))};
  const int slope = kernel.sign(distance.slope), value = kernel.sign(distance.value);
  const auto spans = detail::parallel_spans(kernel, a, b);
  // b reaches a's start; a's end reaches b.
  const HalfLine<W> reached = spans.b_to, left{W(spans.a_length.slope - spans.b_from.slope),
                                               W(spans.a_length.value - spans.b_from.value)};
  if (slope == 0) {
    if (value != 0) return result;
    result.lines = Lines::one_line_always;
    result.interval = intersection_of_half_lines<K>(kernel, std::array{reached, left});
    return result;
  }
  if (slope * value >= 0) return result;  // the lines coincide at a scale <= 0
  result.lines = Lines::one_line_at_one_scale;
  result.scale = slope > 0 ? K::parameter(W(-distance.value), distance.slope)
                           : K::parameter(distance.value, W(-distance.slope));
  const int first = kernel.sign_of_linear(reached.slope, reached.value, result.scale);
  const int second = kernel.sign_of_linear(left.slope, left.value, result.scale);
  if (first < 0 || second < 0) {
    result.meeting = Meeting::never;
  } else {
    result.meeting = first == 0 || second == 0 ? Meeting::touching : Meeting::overlapping;
  }
  return result;
}

}  // namespace minkref::inline plane
