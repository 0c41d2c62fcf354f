#include "reference/plane/dynamic/passing_edges.hpp"

#include <algorithm>

#include "reference/plane/kernel/plain_kernel.hpp"

namespace minkref::inline plane {
namespace {
using V = Vector2<Rational>;

}  // namespace

bool runs_along(const RationalEdge& e, const RationalEdge& f, const Point& point,
                const Rational& scale) {
  const V a = minkref::at(start_of(f), scale), b = minkref::at(end_of(f), scale);
  const Rational along = e.d.x() * point.x + e.d.y() * point.y;
  const Rational from = e.d.dot(a), to = e.d.dot(b);
  return along > std::min(from, to) && along < std::max(from, to);
}

std::pair<SideNumbers, SideNumbers> change_by_passing(const RationalEdge& e, const RationalEdge& f,
                                                      int sign) {
  const int along = minkref::sign(PlainKernel<Rational>::dot(e.d, f.d)) * sign;
  // The lines' distance is linear in the scale: f changes sides.
  const bool to_left = minkref::sign(PlainKernel<Rational>::cross(e.d, V(f.p - e.p))) > 0;
  if (to_left) return {{0, -along}, {-along, 0}};
  return {{along, 0}, {0, along}};
}

}  // namespace minkref::inline plane
