// SPDX-License-Identifier: GPL-3.0-or-later
// A polygon set as triangles.
#pragma once

#include <array>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

using Triangle = std::array<Point, 3>;

/// Cuts the set into counter-clockwise triangles with disjoint interiors, by CGAL's constrained
/// Delaunay triangulation. Keeps a triangle if an odd number of rings surround it. Rings may touch.
/// Exact.
std::vector<Triangle> triangles(const std::vector<Polygon>& polygons);

}  // namespace minkref::cgal_oracle
