// Unions, intersections and differences of polygon sets.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/boundary/canonical.hpp"

namespace minkref::inline plane {

enum class SetOperation : std::uint8_t { unite, intersect, subtract };

/// The closure of the interior of the sets' union, of their intersection, or of the first without
/// the others, in canonical form; empty without sets. Takes valid regions: a point or a segment has
/// no interior, and changes nothing but an intersection, which is empty. Exact. O((n + k) log n)
/// for n vertices and k crossings.
Canonical combined(SetOperation operation, const std::vector<PolygonSet>& sets);

}  // namespace minkref::inline plane
