// The radius of a disc that keeps a clearance: a root less a rational number.
#pragma once

#include "reference/number/radicals/nearest_double.hpp"
#include "reference/number/radicals/root_order.hpp"

namespace minkref::inline disc {

/// The number √squared - clearance, for squared >= 0.
inline RealNumber clear_radius(const RootNumber& squared, const Rational& clearance) {
  RealNumber radius = root_of(squared);
  if (clearance == 0) return radius;
  const auto near = radius.near;
  radius.near = [near, clearance](long bits) { return near(bits) - MpfrInterval(clearance, bits); };
  radius.order = [squared, clearance](const Rational& other) {
    const Rational sum = other + clearance;
    return sum < 0 ? 1 : compare(squared, RootNumber(Rational(sum * sum)));
  };
  radius.known = Interval::whole();
  return radius;
}

/// The sign of √squared - clearance - √asked. Exact.
inline int compare_radius(const RootNumber& squared, const Rational& clearance,
                          const Rational& asked) {
  const RootNumber twice = RootNumber(Rational(2 * clearance)) * sqrt(RootNumber(asked));
  return compare(squared, RootNumber(Rational(asked + clearance * clearance)) + twice);
}

}  // namespace minkref::inline disc
