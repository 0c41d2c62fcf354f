// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/skeleton.hpp"

#include <CGAL/create_offset_polygons_from_polygon_with_holes_2.h>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {

std::vector<Polygon> skeleton_offset(const Polygon& polygon, const mpq_class& radius) {
  const CgalPolygon given = to_cgal(polygon);
  const Kernel::FT distance = to_cgal(mpq_class(abs(radius)));
  const auto offset = radius > 0 ? CGAL::create_exterior_skeleton_and_offset_polygons_with_holes_2(
                                       distance, given, Kernel(), Kernel())
                                 : CGAL::create_interior_skeleton_and_offset_polygons_with_holes_2(
                                       distance, given, Kernel(), Kernel());
  std::vector<Polygon> found;
  for (const auto& part : offset) found.push_back(from_cgal(*part));
  return found;
}

std::string cgal_version_of_skeleton() { return CGAL_VERSION_STR; }

}  // namespace minkref::cgal_oracle
