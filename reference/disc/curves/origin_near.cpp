#include "reference/disc/curves/origin_near.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace minkref::inline disc {
namespace {

namespace mp = boost::multiprecision;

/// value < 2^exponent; value > 0.
long exponent_above(const Rational& value) {
  return static_cast<long>(mp::msb(mp::numerator(value))) -
         static_cast<long>(mp::msb(mp::denominator(value))) + 1;
}

/// Rounds to a multiple of a unit.
Rational rounded_to(const Rational& value, const Rational& unit) {
  const Rational above = value / unit + Rational(1, 2);
  Integer whole = mp::numerator(above) / mp::denominator(above);
  if (above < 0) --whole;
  return Rational(whole) * unit;
}

}  // namespace

Point origin_near(const PolygonSet& P, const Rational& squared_radius, long margin) {
  if (P.empty()) return {0, 0};
  Point low = P.polygons[0].outer[0], high = low;
  for (const Polygon& polygon : P.polygons) {
    for (const Point& p : polygon.outer) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  std::optional<long> size;
  for (const Rational& side : {Rational(high.x - low.x), Rational(high.y - low.y)}) {
    if (side > 0) size = std::max(size.value_or(exponent_above(side)), exponent_above(side));
  }
  if (squared_radius > 0) {
    const long of_radius = exponent_above(squared_radius) / 2 + 1;
    size = std::max(size.value_or(of_radius), of_radius);
  }
  if (!size) return low;  // a point, which may be its own origin
  const long step = *size + margin;
  const Rational power(Integer(1) << static_cast<unsigned>(std::abs(step)));
  const Rational unit = step < 0 ? Rational(1 / power) : power;
  return {rounded_to((low.x + high.x) / 2, unit), rounded_to((low.y + high.y) / 2, unit)};
}

}  // namespace minkref::inline disc
