// P less a disc: the places whose distance from the outside of P is the radius or more.
#pragma once

#include "reference/disc/region/offset_region.hpp"

namespace minkref::inline disc {

/// Erodes P by a disc of radius ρ about the origin, {x : x + ρD within P}: inset, inward offset
/// (docs/erosion.md). The boundary equals the boundary of P's outside plus the disc: rings have the
/// erosion on their right, arcs run about reflex vertices of P. `offset` holds this sum; its tight
/// passages are the remnants. `P` is valid; a point or a segment leaves nothing. Exact. Costs as
/// much as the sum, plus O(h n) for h holes and n pieces. Throws BadInput as offset_region does.
OffsetRegion inset_region(const PolygonSet& P, const Rational& squared_radius,
                          const BuildOptions& options = {},
                          OffsetRoute route = OffsetRoute::definition);

/// Writes the canonical text: the sum's form, marked `"inward":true`.
std::string inset_json(const OffsetRegion& inset);

/// Area and length, enclosed as by measures().
OffsetMeasures inset_measures(const OffsetRegion& inset);

}  // namespace minkref::inline disc
