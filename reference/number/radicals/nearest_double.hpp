// The doubles written for exact numbers: the nearest double, and the neighbours on both sides.
//
// Every double that leaves the library for a number with roots or angles is made here. Intervals of
// more and more bits are asked until they tell; for a number that equals a double, or lies right
// between two, they never would, and its exact order decides.
#pragma once

#include <functional>

#include "reference/number/interval.hpp"
#include "reference/number/radicals/mpfr_interval.hpp"
#include "reference/number/radicals/root_number.hpp"

namespace minkref {

/// A real number that can be known as closely as asked.
struct RealNumber {
  /// An interval that holds the number, and shrinks to it as the precision in bits grows.
  std::function<MpfrInterval(long)> near;
  /// The sign of the number less a rational. Exact. Empty for numbers without a known exact order:
  /// then a result that `most_bits` cannot tell is off by less than one unit in the last place.
  std::function<int(const Rational&)> order;
  /// Bounds known already; the whole line if none.
  Interval known = Interval::whole();

  static constexpr long first_bits = 128, most_bits = 1L << 14;
};

RealNumber real(const RootNumber& value);
/// The root; requires a number >= 0.
RealNumber root_of(const RootNumber& square);

/// The nearest double, ties to even; an infinity beyond the range of doubles, and 0 only where the
/// number is 0 or nearer to 0 than to any other double. Never -0.
double nearest_double(const RealNumber& value);
double nearest_double(const RootNumber& value);

/// The tightest pair of doubles around a number: two equal doubles iff the number is a double.
Enclosure enclose(const RealNumber& value);
Enclosure enclose(const RootNumber& value);

/// A number as the sum of two doubles, the nearest double first.
struct TwoDoubles {
  double high = 0, low = 0;
};

/// Two doubles within 2^-100 of the number, as far as the range of doubles allows.
TwoDoubles two_doubles(const RealNumber& value);

}  // namespace minkref
