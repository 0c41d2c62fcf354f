// Exact sums of many fractions.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/number/rational.hpp"

namespace minkref {

/// Adds terms by pairs, pairs of pairs and so on: denominators without common factors grow long
/// only during the last few additions. Exact.
inline Rational balanced_sum(std::vector<Rational> terms) {
  if (terms.empty()) return 0;
  for (std::size_t step = 1; step < terms.size(); step *= 2) {
    for (std::size_t k = 0; k + step < terms.size(); k += 2 * step) terms[k] += terms[k + step];
  }
  return terms[0];
}

}  // namespace minkref
