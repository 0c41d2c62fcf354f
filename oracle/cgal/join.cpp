// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/join.hpp"

#include <CGAL/Boolean_set_operations_2.h>

#include <iterator>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {

std::vector<Polygon> join_of(const std::vector<std::vector<Polygon>>& sets) {
  std::vector<CgalPolygon> polygons, joined;
  for (const std::vector<Polygon>& set : sets) {
    for (const Polygon& polygon : set) {
      if (polygon.outer.size() > 2) polygons.push_back(to_cgal(polygon));
    }
  }
  CGAL::join(polygons.begin(), polygons.end(), std::back_inserter(joined));
  std::vector<Polygon> found;
  for (const CgalPolygon& polygon : joined) found.push_back(from_cgal(polygon));
  return found;
}

std::string cgal_version_of_join() { return CGAL_VERSION_STR; }

}  // namespace minkref::cgal_oracle
