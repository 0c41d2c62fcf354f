// The doubles that are written for exact numbers: the nearest one, and the two next to it.
//
// Every double that leaves the library for a number with roots or angles is made here. Intervals of
// more and more bits are asked until they tell; where they never would, since the number is a
// double or right between two, its exact order does.
#pragma once

#include <functional>

#include "reference/number/interval.hpp"
#include "reference/number/radicals/mpfr_interval.hpp"
#include "reference/number/radicals/root_number.hpp"

namespace minkref {

/// A real number that can be known as closely as asked.
struct RealNumber {
  /// Holds the number; shrinks to it as the precision in bits grows.
  std::function<MpfrInterval(long)> near;
  /// The sign of the number less a rational. Exact. Empty for numbers of which no exact order is
  /// known: then what cannot be told by `most_bits` is off by less than one unit in the last place.
  std::function<int(const Rational&)> order;
  /// The bounds that are known already; the whole line if none are.
  Interval known = Interval::whole();

  static constexpr long first_bits = 128, most_bits = 1L << 14;
};

RealNumber real(const RootNumber& value);
/// The root of a number that is not negative.
RealNumber root_of(const RootNumber& square);

/// The nearest double, ties to even; an infinity beyond the range of doubles, and 0 only where the
/// number is 0 or nearer to 0 than to any other double. Never -0.
double nearest_double(const RealNumber& value);
double nearest_double(const RootNumber& value);

/// The tightest pair of doubles around a number: equal iff it is a double.
Enclosure enclose(const RealNumber& value);
Enclosure enclose(const RootNumber& value);

/// A number as the sum of two doubles, the first one the nearest.
struct TwoDoubles {
  double high = 0, low = 0;
};

/// Within 2^-100 of the number, as far as the range of doubles allows.
TwoDoubles two_doubles(const RealNumber& value);

}  // namespace minkref
