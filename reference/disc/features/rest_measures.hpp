// Areas of rest material.
#pragma once

#include "reference/disc/features/rest_material.hpp"

namespace minkref::inline disc {

/// Whether a ring goes round a component of the rest, and not along what the component surrounds.
bool is_around_rest(const RegionOutlines& outlines, const RestMaterial& rest, const RestRing& ring);

/// The area between two neighbouring doubles, in coordinates of P: within one feature's region, or
/// in all. Transcendental if there is an arc, since the angles add up to an amount whose sine is
/// algebraic and which is not 0 (Lindemann); so bits tell. Else the area of a region.
Interval rest_area(const RegionOutlines& outlines, const RestMaterial& rest,
                   const std::vector<std::size_t>& features);

}  // namespace minkref::inline disc
