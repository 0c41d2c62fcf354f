// Unions, intersections and differences of polygon sets.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/boundary/set_boundary.hpp"

namespace minkref::inline plane {

enum class SetOperation : std::uint8_t { unite, intersect, subtract };

/// The closure of the interior of the sets' union, of their intersection, or of the first without
/// the others, in canonical form; empty without sets. Takes valid regions: a point or a segment has
/// no interior, and changes nothing but an intersection, which is empty. Exact. O((n + k) log n)
/// for n vertices and k crossings.
Canonical combined(SetOperation operation, const std::vector<PolygonSet>& sets);

/// The closure of the points that lie inside the rings by a rule, however they cross, overlap or
/// run; in canonical form. `well_formed`: every winding number is 0 or 1. Exact. O((n + k) log n).
Canonical filled(const PolygonSet& rings, FillRule rule);

}  // namespace minkref::inline plane
