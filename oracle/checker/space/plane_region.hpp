// Unites convex polygons without overlaps in a plane. docs/definitions.md
#pragma once

#include <gmpxx.h>

#include <utility>
#include <vector>

#include "oracle/checker/budget.hpp"

namespace minkref::checker {

using PlanePoint = std::pair<mpq_class, mpq_class>;
using PlaneRing = std::vector<PlanePoint>;
/// The outer ring, and the holes.
using PlanePolygon = std::vector<PlaneRing>;

mpq_class doubled_area(const PlaneRing& ring);

/// Returns the union in canonical form. The polygons run counter-clockwise. Throws NotVerified.
std::vector<PlanePolygon> united(const std::vector<PlaneRing>& tiles, Budget& budget);

}  // namespace minkref::checker
