// Windows for indexing, and index sums compared with static sums.
#pragma once

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/sum.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing {

inline ScaleWindow some_window(const Case& c) {
  if (c.scale == 1) return {};
  if (c.scale == 2) return {Rational(1, 3), std::nullopt};
  return {c.scale / 2, c.scale * 3};
}

/// Empty iff `found` is the sum at the scale.
inline std::string fault_of_sum(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                                const Sum& found) {
  const Sum expected = minkowski_sum(P, Q, scale);
  if (found.region == expected.region && found.components == expected.components &&
      found.holes == expected.holes) {
    return "";
  }
  return "at scale " + to_string(scale) + ": " + unequal(expected.region, found.region);
}

}  // namespace minkref::testing
