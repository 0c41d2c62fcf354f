// A factor for each axis (docs/definitions.md, "Scaling"; Behar & Lien 2012, Sec. 1).
#pragma once

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// S = diag(x, y). `S P + Q` is the sum of the operand S P and Q: `minkowski_sum(scaled(P, S), Q,
/// 1)`, by any route and in any arithmetic.
struct PlaneScaling {
  Rational x = 1, y = 1;
  friend bool operator==(const PlaneScaling&, const PlaneScaling&) = default;
};

/// Throws BadInput ("bad-scale") unless both factors are positive.
void require_positive(const PlaneScaling& scaling);

/// S P: the same rings and vertices in the same order, so that S P is valid iff P is. Exact, O(n).
/// Throws as require_positive.
PolygonSet scaled(const PolygonSet& set, const PlaneScaling& scaling);

}  // namespace minkref::inline plane
