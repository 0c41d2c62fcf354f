// Erosion, opening, closing: what is left of a set where another one has room (docs/erosion.md).
#pragma once

#include <optional>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// The erosion `sP - Q = {x : x + Q within sP}` at a rational scale s > 0. `region`: the closure of
/// its interior, canonical; `tight_passages`: its remnants, the points and polylines of the erosion
/// beside the region, with the contacts of P and -Q. Both together are the whole erosion. Exact.
/// P and Q, perhaps points or segments, must have passed `validate`. Computed as the holes of the
/// sum of P's outside and -Q, at the cost of that sum; nothing is computed where Q's box does not
/// fit into that of sP. Throws BadInput for s <= 0 ("bad-scale") and an empty Q ("empty-operand"):
/// each place is in the erosion by the empty set.
Sum erosion(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
            Route route = Route::paper);

/// The opening `(sP - Q) + Q`: all copies of Q within sP together. Where Q is a segment or a point,
/// `tight_passages` has what of it lies beside the region, without contacts. Exact; throws as
/// erosion does.
Sum opening(const PolygonSet& P, const PolygonSet& Q, const Rational& scale);

/// The closing `(sP + Q) - Q`, with its remnants. Exact; throws as erosion and minkowski_sum do.
Sum closing(const PolygonSet& P, const PolygonSet& Q, const Rational& scale);

/// The least scale at which Q's box fits into that of sP, 0 for a point: below it the erosion is
/// empty. None if it fits at no scale. Both sets are not empty. Exact.
std::optional<Rational> least_scale_with_room(const PolygonSet& P, const PolygonSet& Q);

/// The holes of a sum of an outside (outside.hpp) as a set of their own, canonical, with its
/// components and holes. `sum` is the region of that sum at a scale that is at least half of
/// least_scale_with_room. Exact. O((n + k) log n).
Canonical inside_out(const PolygonSet& sum);

/// `-Q`: Q turned by half a turn about the origin; each ring and vertex keeps its number.
PolygonSet negated(const PolygonSet& Q);

}  // namespace minkref::inline plane
