// The paper's way to the pair events (Behar & Lien 2012, Sec. 4.2) in its own arithmetic, on trial
// against the exact events.
#pragma once

#include <cstdint>
#include <string>

#include "reference/form.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref {

struct PrecisionTrial {
  std::uint64_t pairs = 0;            ///< not parallel
  std::uint64_t undecided_pairs = 0;  ///< the arithmetic could not tell a sign; left out below

  // Four solves s alpha = beta for each pair.
  std::uint64_t roots = 0;               ///< solves with a root, in truth
  std::uint64_t false_inconsistent = 0;  ///< of `roots`: answered "inconsistent"
  std::uint64_t false_identity = 0;      ///< of `roots`: answered "identity"
  std::uint64_t invented_roots = 0;      ///< a root answered, but none in truth

  // Births, deaths and touches, matched by pair and change.
  std::uint64_t events = 0;    ///< in truth
  std::uint64_t missed = 0;    ///< in truth, not answered
  std::uint64_t invented = 0;  ///< answered, not in truth
  std::uint64_t misplaced =
      0;  ///< answered, off by more than an ulp of the scale in this precision
  std::uint64_t inversions = 0;  ///< pairs of events answered in the opposite order
  std::uint64_t merged = 0;      ///< neighbours of different scales answered as one

  bool all_right() const { return undecided_pairs + missed + invented + inversions + merged == 0; }
};

/// Follows the paper's way, pair by pair: x(1), x(2), sigma, alpha and beta of each end point, the
/// solves and the interval by `form`; "rational", "interval", "double" or "mpfr:BITS". For
/// `interval` a scale is misplaced if the interval does not hold it; intervals are ordered by their
/// middles. O(N^2).
PrecisionTrial precision_trial(const PolygonSet& P, const PolygonSet& Q,
                               const std::string& arithmetic, Form form);

}  // namespace minkref
