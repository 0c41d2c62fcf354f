// Erosion, opening, closing (docs/erosion.md).
#pragma once

#include <optional>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::inline plane {

/// Erodes P at a rational scale s > 0: `sP - Q = {x : x + Q within sP}`. `region`: the closed
/// interior, canonical; `tight_passages`: remnants, points and polylines beside the region, with
/// contacts between P and -Q. Both together make the whole erosion. Exact. P and Q, perhaps points
/// or segments, must have passed `validate`. Takes the holes of the sum of P's outside and -Q, at
/// this sum's cost; computes nothing if Q's box has no room. Throws BadInput for s <= 0
/// ("bad-scale") and for an empty Q ("empty-operand"), since x + Q then always lies within P.
Sum erosion(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
            Route route = Route::paper);

/// Opens sP: unites all copies of Q within sP, `(sP - Q) + Q`. For a segment or a point Q,
/// `tight_passages` holds parts beside the region, without contacts. Exact; throws as erosion does.
Sum opening(const PolygonSet& P, const PolygonSet& Q, const Rational& scale);

/// Closes sP: `(sP + Q) - Q`, with remnants. Exact; throws as erosion and minkowski_sum do.
Sum closing(const PolygonSet& P, const PolygonSet& Q, const Rational& scale);

/// Finds the least scale at which Q's box fits into sP's box, 0 for a point; none if no scale fits.
/// The erosion is empty below. P and Q must not be empty. Exact.
std::optional<Rational> least_scale_with_room(const PolygonSet& P, const PolygonSet& Q);

/// Turns a sum's holes into a set, canonical, with components and holes. `sum`: an outside
/// (outside.hpp) plus -Q, at half of least_scale_with_room or more. Exact. O((n + k) log n).
Canonical inside_out(const PolygonSet& sum);

/// Turns Q by half a turn about the origin, to `-Q`; rings and vertices keep their numbers.
PolygonSet negated(const PolygonSet& Q);

}  // namespace minkref::inline plane
