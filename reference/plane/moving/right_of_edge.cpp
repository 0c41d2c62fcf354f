#include "reference/plane/moving/right_of_edge.hpp"

#include <optional>

#include "reference/fault.hpp"

namespace minkref::inline plane {
namespace {

using V = Vector2<Rational>;

}  // namespace

bool sum_on_the_right(const std::vector<RationalEdge>& edges, std::uint32_t edge, const Point& x,
                      const Rational& scale, const InteriorTest& interior) {
  const V from(x.x, x.y), right(edges[edge].d.y(), -edges[edge].d.x());
  std::optional<Rational> nearest;
  for (const RationalEdge& f : edges) {
    const V a = V(minkref::at(start_of(f), scale) - from),
            b = V(minkref::at(end_of(f), scale) - from);
    const Rational side_a = right.x() * a.y() - right.y() * a.x();
    const Rational side_b = right.x() * b.y() - right.y() * b.x();
    std::vector<V> meetings;
    if (side_a == 0) meetings.push_back(a);
    if (side_b == 0) meetings.push_back(b);
    if (sign(side_a) * sign(side_b) < 0) {
      const Rational t = side_a / (side_a - side_b);
      meetings.push_back(V(a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y())));
    }
    for (const V& v : meetings) {
      const Rational along = v.dot(right) / right.dot(right);
      if (sign(along) > 0 && (!nearest || along < *nearest)) nearest = along;
    }
  }
  if (!nearest || planted(Fault::right_side_forgotten)) return false;  // the unbounded face
  const Rational half = *nearest / 2;
  return interior.in_closed_sum({x.x + half * right.x(), x.y + half * right.y()}, scale);
}

}  // namespace minkref::inline plane
