#include "reference/plane/moving/track.hpp"

namespace minkref::inline plane {

Track track_along(const RationalEdge& edge, const PositionAlong<Rational>& position) {
  const Rational value = position.value / position.den, slope = position.slope / position.den;
  const auto &p = edge.p, &q = edge.q, &d = edge.d;
  return {{Rational(q.x() + d.x() * value), Rational(q.y() + d.y() * value)},
          {Rational(p.x() + d.x() * slope), Rational(p.y() + d.y() * slope)}};
}

}  // namespace minkref::inline plane
