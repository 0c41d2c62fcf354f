#include "reference/plane/thin_sum.hpp"

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/passages/bare_segments.hpp"

namespace minkref::inline plane {

std::vector<TightPassage> sum_remnants(const PolygonSet& P, const PolygonSet& Q,
                                       const Rational& scale, const PolygonSet& region) {
  const FloatEnvironment standard;
  std::vector<BareSegment> flat;
  const std::vector<BareSegment> p = segments_of(scaled(P, scale)), q = segments_of(Q);
  for (const BareSegment& a : p) {
    for (const BareSegment& b : q) {
      look_for_interrupt();
      const Rational turn =
          (a.to.x - a.from.x) * (b.to.y - b.from.y) - (a.to.y - a.from.y) * (b.to.x - b.from.x);
      if (turn != 0) continue;
      flat.push_back(
          {{a.from.x + b.from.x, a.from.y + b.from.y}, {a.to.x + b.to.x, a.to.y + b.to.y}});
    }
  }
  return segments_beside(region, std::move(flat));
}

}  // namespace minkref::inline plane
