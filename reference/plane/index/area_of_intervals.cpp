#include "reference/plane/index/area_of_intervals.hpp"

#include <algorithm>
#include <cmath>

namespace minkref::inline plane {
namespace {

/// The greatest relevant power of two, for twice the area below any link.
int magnitude(const MovingBoundary& boundary) {
  double largest = 0;
  for (const Track& track : boundary.tracks) {
    for (const Rational* c : {&track.a.x, &track.a.y, &track.b.x, &track.b.y}) {
      largest = std::max(largest, std::fabs(to_double(*c)));
    }
  }
  return largest > 0 && std::isfinite(largest) ? 2 * std::ilogb(largest) + 3 : 0;
}

/// Rounded down to a multiple of 2^-places.
Integer fixed_point(const Rational& value, int places) {
  Integer num = numerator(value), den = denominator(value);
  if (places >= 0) {
    num <<= static_cast<unsigned>(places);
  } else {
    den <<= static_cast<unsigned>(-places);
  }
  Integer result;
  mpz_fdiv_q(result.backend().data(), num.backend().data(), den.backend().data());
  return result;
}

double floating(const Integer& value, int places) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, value.backend().data());
  return std::ldexp(mantissa, static_cast<int>(exponent) - places);
}

}  // namespace

std::array<Rational, 3> area_below(const Track& from, const Track& to) {
  const auto cross = [](const Point& u, const Point& v) { return Rational(u.x * v.y - u.y * v.x); };
  return {cross(from.a, to.a) / 2, (cross(from.a, to.b) + cross(from.b, to.a)) / 2,
          cross(from.b, to.b) / 2};
}

std::vector<IndexArea> areas_of_intervals(const MovingBoundary& boundary,
                                          const BuildControl& control) {
  const std::size_t intervals = boundary.events.size() + 1;
  const int places = 160 - magnitude(boundary);
  std::vector<std::array<Integer, 3>> change(intervals + 1);
  std::vector<std::int64_t> more(intervals + 1);
  for (const MovingLink& link : boundary.links) {
    control.look();
    const auto exact = area_below(boundary.tracks[link.from], boundary.tracks[link.to]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Integer part = fixed_point(exact[k], places);
      change[link.first][k] += part;
      change[link.last + 1][k] -= part;
    }
    ++more[link.first];
    --more[link.last + 1];
  }
  std::vector<IndexArea> result;
  std::array<Integer, 3> sum;
  std::int64_t links = 0;
  for (std::size_t interval = 0; interval < intervals; ++interval) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += change[interval][k];
    links += more[interval];
    // mpz_get_d_2exp cuts off: up to an ulp, which the query counts.
    result.push_back({floating(sum[0], places), floating(sum[1], places), floating(sum[2], places),
                      std::ldexp(static_cast<double>(links) + 1, -places)});
  }
  return result;
}

}  // namespace minkref::inline plane
