// When two convolution edges meet: the conditions on the scale, each linear in it.
#pragma once

#include <array>
#include <cstdint>

#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

/// slope s + value >= 0.
template <class W>
struct HalfLine {
  W slope = W(0), value = W(0);
};

/// The end point of a pair (a, b) that a condition names.
enum class PairEnd : std::uint8_t { a0, a1, b0, b1 };

/// With A and B of docs/definitions.md, "Printed and corrected": the lines of a and b meet at
/// a0 + A / |c| d_a = b0 + B / |c| d_b, so the edges meet iff
/// A >= 0, |c| L_a - A >= 0, B >= 0, |c| L_b - B >= 0, in the order of PairEnd.
template <class W>
struct PairConditions {
  int turn = 0;  ///< sign of c = d_a x d_b; 0: parallel, and the half-lines are not set
  std::array<HalfLine<W>, 4> half_lines;
};

template <class K>
PairConditions<typename K::Wide> pair_conditions(const K& kernel,
                                                 const MovingEdge<typename K::Vector>& a,
                                                 const MovingEdge<typename K::Vector>& b) {
  using W = typename K::Wide;
  PairConditions<W> result;
  W c = K::cross(a.d, b.d);
  result.turn = kernel.sign(c);
  if (result.turn == 0) return result;
  const typename K::Vector p(b.p - a.p), q(b.q - a.q);
  HalfLine<W> A{K::cross(p, b.d), K::cross(q, b.d)}, B{K::cross(p, a.d), K::cross(q, a.d)};
  if (result.turn < 0) {
    c = -c;
    A = {W(-A.slope), W(-A.value)};
    B = {W(-B.slope), W(-B.value)};
  }
  const auto rest = [&](const HalfLine<W>& along, bool s_edge) -> HalfLine<W> {
    return s_edge ? HalfLine<W>{W(c - along.slope), W(-along.value)}
                  : HalfLine<W>{W(-along.slope), W(c - along.value)};
  };
  result.half_lines = {A, rest(A, a.is_s()), B, rest(B, b.is_s())};
  return result;
}

}  // namespace minkref::inline plane
