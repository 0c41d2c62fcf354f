#include "reference/number/radicals/nearest_double.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "reference/error.hpp"

namespace minkref {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The double as a rational, with ±2^1024 for the infinities: the numbers next beyond the greatest
/// doubles, so that midpoints exist.
Rational finite(double value) {
  if (std::isfinite(value)) return from_double(value);
  const Rational beyond(Integer(1) << 1024U);
  return value < 0 ? Rational(-beyond) : beyond;
}

bool is_even(double value) { return (std::bit_cast<std::uint64_t>(value) & 1U) == 0; }

/// The nearer of two neighbouring doubles, given the number's side of their midpoint.
double nearer(double low, double high, int side) {
  if (side != 0) return side < 0 ? low : high;
  return is_even(low) ? low : high;
}

[[noreturn]] void refuse_to_tell() {
  throw LimitExceeded(
      "too-many-digits",
      "a number cannot be told by " + std::to_string(RealNumber::most_bits) + " bits",
      "give coordinates and radii with fewer digits");
}

bool are_neighbours(double low, double high) { return std::nextafter(low, infinity) == high; }

}  // namespace

RealNumber real(const RootNumber& value) {
  return {[value](long bits) { return value.enclosure(bits); },
          [value](const Rational& other) { return sign(value - RootNumber(other)); },
          value.enclosure()};
}

RealNumber root_of(const RootNumber& square) {
  return {[square](long bits) { return sqrt(square.enclosure(bits)); },
          [square](const Rational& other) {
            if (other < 0) return 1;
            return sign(square - RootNumber(Rational(other * other)));
          },
          Interval::whole()};
}

double nearest_double(const RootNumber& value) {
  if (value.field()->roots() == 0) return to_double(value.coefficients()[0]) + 0.0;
  return nearest_double(real(value));
}

Enclosure enclose(const RootNumber& value) {
  if (value.field()->roots() == 0) return enclose(value.coefficients()[0]);
  return enclose(real(value));
}

double nearest_double(const RealNumber& value) {
  if (value.known.is_point()) return value.known.lower() + 0.0;
  for (long bits = RealNumber::first_bits;; bits *= 2) {
    const Enclosure bounds = value.near(bits).nearest();
    const auto [low, high] = bounds;
    if (low == high) return low;
    if (value.order && low <= 0 && high >= 0 && value.order(Rational(0)) == 0) return 0;
    if (!are_neighbours(low, high)) {
      if (!value.order && bits >= RealNumber::most_bits) refuse_to_tell();
      continue;
    }
    if (value.order) {
      return nearer(low, high, value.order(Rational((finite(low) + finite(high)) / 2))) + 0.0;
    }
    if (bits >= RealNumber::most_bits) return nearer(low, high, 0);
  }
}

TwoDoubles two_doubles(const RealNumber& value) {
  constexpr double share = 0x1p-101, least = std::numeric_limits<double>::min();
  for (long bits = RealNumber::first_bits;; bits *= 2) {
    const MpfrInterval near = value.near(bits);
    const double high = near.nearest().lower;
    if (!std::isfinite(high)) return {high, 0};
    const auto [low, above] = (near - MpfrInterval(from_double(high), bits)).outwards();
    if (above - low <= share * std::abs(high) || above - low < least) return {high, low};
    if (value.order && high == 0 && value.order(Rational(0)) == 0) return {0, 0};
    if (bits >= RealNumber::most_bits && !value.order) refuse_to_tell();
  }
}

Enclosure enclose(const RealNumber& value) {
  if (value.known.is_point()) return {value.known.lower() + 0.0, value.known.lower() + 0.0};
  for (long bits = RealNumber::first_bits;; bits *= 2) {
    const MpfrInterval near = value.near(bits);
    const auto [low, high] = near.outwards();
    if (low == high) return {low, low};
    const bool is_told = are_neighbours(low, high);
    if (is_told && near.is_strictly_between(low, high)) return {low, high};
    if (!value.order) {
      if (is_told) return {low, high};
      if (bits >= RealNumber::most_bits) refuse_to_tell();
      continue;
    }
    // The number may equal a double: a bound, or the double between.
    const double middle = is_told ? low : std::nextafter(low, infinity);
    if (!is_told && std::nextafter(middle, infinity) != high) continue;
    const auto order = [&](double at) { return value.order(finite(at)); };
    const int side = order(middle);
    if (side == 0) return {middle, middle};
    if (!is_told) return side < 0 ? Enclosure{low, middle} : Enclosure{middle, high};
    if (order(high) == 0) return {high, high};
    return {low, high};
  }
}

}  // namespace minkref
