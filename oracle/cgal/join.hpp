// SPDX-License-Identifier: GPL-3.0-or-later
// The union of polygon sets by CGAL. No CGAL here.
#pragma once

#include <string>
#include <vector>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// Calls CGAL::join on all polygons of all sets at once. Exact; what has no interior is left out.
std::vector<Polygon> join_of(const std::vector<std::vector<Polygon>>& sets);

std::string cgal_version_of_join();

}  // namespace minkref::cgal_oracle
