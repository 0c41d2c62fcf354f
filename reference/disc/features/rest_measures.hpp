// Rest material's areas.
#pragma once

#include "reference/disc/features/rest_material.hpp"

namespace minkref::inline disc {

/// Whether a ring goes round a component, and not along an island or a gap inside.
bool is_around_rest(const RegionOutlines& outlines, const RestMaterial& rest, const RestRing& ring);

/// Whether a ring around a component goes round another ring, which shares no more than single
/// points with it. The ring has a part of P's boundary. Exact: intervals certify the angle that one
/// turns through as seen from a point of the other. Throws LimitExceeded ("nested-rest") if 2^14
/// bits tell nothing.
bool is_within_ring(const RegionOutlines& outlines, const RestMaterial& rest,
                    const RestRing& around, const RestRing& ring);

/// Encloses the area within some features' regions between two neighbouring doubles. With arcs the
/// area is transcendental, since the angles' sum has an algebraic sine and differs from 0
/// (Lindemann), so bits tell. Without arcs: a region's area.
Interval rest_area(const RegionOutlines& outlines, const RestMaterial& rest,
                   const std::vector<std::size_t>& features);

/// The same for a given area together with all rest, or without it (`sign` 1 or -1).
Interval area_with_rest(const RegionOutlines& outlines, const RestMaterial& rest,
                        const Rational& area, int sign);

}  // namespace minkref::inline disc
