// Whether two segments meet, from signs of turns alone.
#pragma once

#include "reference/number/eigen.hpp"
#include "reference/number/rational.hpp"

namespace minkref::testing {

/// Whether the closed segments share a point; either segment may lie on the other's line.
inline bool do_segments_meet(const Vector2<Rational>& a0, const Vector2<Rational>& a1,
                             const Vector2<Rational>& b0, const Vector2<Rational>& b1) {
  using Vector = Vector2<Rational>;
  const auto side = [](const Vector& from, const Vector& to, const Vector& x) {
    return sign(Rational((to.x() - from.x()) * (x.y() - from.y()) -
                         (to.y() - from.y()) * (x.x() - from.x())));
  };
  const auto between = [](const Rational& x, const Rational& u, const Rational& v) {
    return u < v ? u <= x && x <= v : v <= x && x <= u;
  };
  const auto on = [&](const Vector& from, const Vector& to, const Vector& x) {
    return side(from, to, x) == 0 && between(x.x(), from.x(), to.x()) &&
           between(x.y(), from.y(), to.y());
  };
  if (on(a0, a1, b0) || on(a0, a1, b1) || on(b0, b1, a0) || on(b0, b1, a1)) return true;
  return side(a0, a1, b0) * side(a0, a1, b1) < 0 && side(b0, b1, a0) * side(b0, b1, a1) < 0;
}

}  // namespace minkref::testing
