// P less a disc: the places whose distance from the outside of P is the radius or more.
#pragma once

#include "reference/disc/region/offset_region.hpp"

namespace minkref::inline disc {

/// The erosion of P by a disc of radius ρ about the origin, {x : x + ρD within P}: inset, inward
/// offset (docs/erosion.md). Its boundary is that of the sum of P's outside and the disc, seen from
/// the other side: rings have the erosion on their right, and arcs are about reflex vertices of P.
/// `offset` is that sum, whose tight passages are the remnants. `P` is valid; a point or a segment
/// leaves nothing. Exact. Costs as much as that sum, plus O(h n) for h holes and n pieces. Throws
/// BadInput as offset_region does.
OffsetRegion inset_region(const PolygonSet& P, const Rational& squared_radius,
                          const BuildOptions& options = {},
                          OffsetRoute route = OffsetRoute::definition);

/// The canonical text of what inset_region gives: that of the sum with the mark `"inward":true`.
std::string inset_json(const OffsetRegion& inset);

/// Area and length of what inset_region gives, as measures() has them.
OffsetMeasures inset_measures(const OffsetRegion& inset);

}  // namespace minkref::inline disc
