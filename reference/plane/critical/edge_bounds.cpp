#include "reference/plane/critical/edge_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace minkref::inline plane {
namespace {

// Between these bounds, products and sums neither overflow nor become too small for a relative
// error.
constexpr double least_factor = 1e-100, greatest_factor = 1e100;

bool is_plain(double value) {
  return std::abs(value) >= least_factor && std::abs(value) <= greatest_factor;
}

}  // namespace

EdgeBounds::EdgeBounds(const std::vector<RationalEdge>& edges) {
  const auto number = [](const Rational& p, const Rational& q) -> Number {
    Number result{to_double(p), to_double(q)};
    result.usable = (sign(p) == 0 || is_plain(result.p)) && (sign(q) == 0 || is_plain(result.q));
    return result;
  };
  ends_.reserve(edges.size());
  for (const RationalEdge& edge : edges) {
    look_for_interrupt();
    const auto of = [&](const MovingVertex<Vector2<Rational>>& end) -> std::array<Number, 2> {
      return {number(end.p.x(), end.q.x()), number(end.p.y(), end.q.y())};
    };
    ends_.push_back({of(start_of(edge)), of(end_of(edge))});
  }
}

Enclosure EdgeBounds::of_end(std::uint32_t edge, bool second, int coordinate, double scale) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Number& number = ends_[edge][second][static_cast<std::size_t>(coordinate)];
  if (!number.usable || !is_plain(scale)) return {-infinity, infinity};
  // The scale has a relative error of 2^-48, p and q of 2^-53; the product and the sum are rounded.
  constexpr double error = 1.0 / (std::uint64_t{1} << 46);
  const double moved = scale * number.p, value = moved + number.q;
  const double most = (std::abs(moved) + std::abs(number.q)) * error;
  return {value - most, value + most};
}

Enclosure EdgeBounds::of_edge(std::uint32_t edge, int coordinate, double scale) const {
  const Enclosure first = of_end(edge, false, coordinate, scale);
  const Enclosure second = of_end(edge, true, coordinate, scale);
  return {std::min(first.lower, second.lower), std::max(first.upper, second.upper)};
}

Enclosure intersection(const Enclosure& x, const Enclosure& y) {
  return {std::max(x.lower, y.lower), std::min(x.upper, y.upper)};
}

}  // namespace minkref::inline plane
