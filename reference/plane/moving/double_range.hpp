// The range where a double has its full relative accuracy: far from underflow and overflow.
#pragma once

#include <cmath>
#include <limits>

#include "reference/plane/moving/position_difference.hpp"

namespace minkref::inline plane {

inline constexpr double least_filtered = 1e-290, most_filtered = 1e290;

/// Whether a double near a nonzero number has the relative accuracy of rounding, and a product with
/// another such double does no harm beyond 1e-300.
inline bool in_filter_range(double x) {
  return std::abs(x) >= least_filtered && std::abs(x) <= most_filtered;
}

/// The double next to a number; out of range NaN, which decides no comparison.
inline double filter_double(const Rational& value) {
  if (sign(value) == 0) return 0;
  const double nearest = to_double(value);
  return in_filter_range(nearest) ? nearest : std::numeric_limits<double>::quiet_NaN();
}

/// As filter_double, for a quotient.
template <class Wide>
double filter_quotient(const Wide& num, const Wide& den) {
  if (wide_sign(num) == 0) return 0;
  const double nearest = wide_quotient(num, den);
  return in_filter_range(nearest) ? nearest : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace minkref::inline plane
