// Where a program's answer is another set than P ⊕ ρD.
#pragma once

#include <optional>

#include "reference/paper/disc/disc_answer.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline disc {

/// A point that is in one of the two sets only.
struct DiscWitness {
  Point point;
  bool in_sum;  ///< it is in the sum, and the answer lost it; else the answer added it
};

/// Looks for a point that an answer's rings, with corners as the answer has them in doubles, hold
/// and the sum does not, or the other way round: beside the boundaries of both, and on a grid. The
/// exact distance from P tells whether the point is in the sum; points at just the radius are left
/// out. None found does not mean that the sets are equal. O(k (n + k)) for k pieces, n edges.
std::optional<DiscWitness> disc_witness(const PolygonSet& P, const Rational& squared_radius,
                                        const DiscAnswer& answer);

}  // namespace minkref::inline disc
