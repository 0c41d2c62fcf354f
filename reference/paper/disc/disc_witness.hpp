// A point where a program's answer differs from P ⊕ ρD.
#pragma once

#include <optional>

#include "reference/paper/disc/disc_answer.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline disc {

/// A point in the sum or in the answer, not in both.
struct DiscWitness {
  Point point;
  bool in_sum;  ///< the answer lost the point; otherwise the answer added it
};

/// Looks for a witness beside both boundaries and on a grid. The answer's rings have their corners
/// rounded to doubles; the exact distance from P decides about the sum. No witness does not prove
/// equal sets. O(k (n + k)) for k pieces, n edges.
std::optional<DiscWitness> disc_witness(const PolygonSet& P, const Rational& squared_radius,
                                        const DiscAnswer& answer);

}  // namespace minkref::inline disc
