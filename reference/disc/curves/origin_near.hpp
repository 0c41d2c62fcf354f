// A frame for sets far from the origin.
#pragma once

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline disc {

/// A point near P in few bits, so that numbers measured from it are told well by doubles; (0, 0)
/// where P is 2^margin times as near to the origin as it, or the disc, is large. Not farther from P
/// than that.
Point origin_near(const PolygonSet& P, const Rational& squared_radius, long margin);

}  // namespace minkref::inline disc
