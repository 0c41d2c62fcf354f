#include "reference/plane/kernel/frame.hpp"

#include <limits>

#include "reference/interrupt.hpp"

namespace minkref::inline plane {

GridFit grid_fit(const std::vector<const PolygonSet*>& sets, std::size_t limit) {
  GridFit fit;
  const auto each = [&](auto&& visit) {
    for (const PolygonSet* set : sets) {
      for (const Polygon& polygon : set->polygons) {
        for (std::size_t r = 0; r <= polygon.holes.size(); ++r) {
          for (const Point& p : r == 0 ? polygon.outer : polygon.holes[r - 1]) {
            look_for_interrupt();
            visit(p.x);
            visit(p.y);
          }
        }
      }
    }
  };
  const auto bits = [](const Integer& value) -> std::size_t {
    return value == 0 ? 0 : msb(value < 0 ? Integer(-value) : value) + 1;
  };
  bool fits = true;
  each([&](const Rational& value) {
    if (!fits) return;
    const Integer den = denominator(value);
    if (den != 1 && fit.denominator % den != 0) fit.denominator = lcm(fit.denominator, den);
    fits = bits(fit.denominator) <= limit;
  });
  if (fits) {
    each([&](const Rational& value) {
      const Integer scaled = numerator(value) * (fit.denominator / denominator(value));
      fit.bits = std::max(fit.bits, bits(scaled));
    });
  }
  if (!fits || fit.bits > limit) fit.bits = std::numeric_limits<std::size_t>::max();
  return fit;
}

}  // namespace minkref::inline plane
