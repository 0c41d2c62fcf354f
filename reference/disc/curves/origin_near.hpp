// A frame for sets far from the origin.
#pragma once

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline disc {

/// A point near P with few bits, so that doubles represent numbers measured from there well; (0, 0)
/// if P lies no farther from the origin than 2^margin times the size of P or of the disc. The point
/// lies no farther from P than that.
Point origin_near(const PolygonSet& P, const Rational& squared_radius, long margin);

}  // namespace minkref::inline disc
