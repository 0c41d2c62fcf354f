// SPDX-License-Identifier: GPL-3.0-or-later
// A polygon grown or shrunk along CGAL's straight skeleton: sharp corners. No CGAL here.
#pragma once

#include <string>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// Calls create_exterior_skeleton_and_offset_polygons_with_holes_2 for a radius above 0, and
/// create_interior_skeleton_and_offset_polygons_with_holes_2 for one below, on one strictly simple
/// polygon with holes. Predicates and constructions are exact, except that CGAL rounds lengths of
/// sides to doubles, so each offset line is off by about 2^-52 of its distance.
std::vector<Polygon> skeleton_offset(const Polygon& polygon, const mpq_class& radius);

std::string cgal_version_of_skeleton();

}  // namespace minkref::cgal_oracle
