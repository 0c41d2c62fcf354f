#include "reference/plane/moving/right_of_edge.hpp"

#include "reference/plane/lines.hpp"
#include "reference/plane/passages/wedge_walks.hpp"

namespace minkref::inline plane {

bool may_hide_passages(const PolygonSet& P, const PolygonSet& Q) {
  const auto has_two_sides = [](const PolygonSet& set) {
    return set.is_segment() || is_lines(set) || wedge_walks(set).has_value();
  };
  return has_two_sides(P) && has_two_sides(Q);
}

bool sum_on_the_right(const RationalEdge& edge, const Point& x, const Rational& scale,
                      const InteriorTest& interior) {
  return interior.in_sum_beside(x, {edge.d.y(), -edge.d.x()}, scale);
}

}  // namespace minkref::inline plane
