// SPDX-License-Identifier: GPL-3.0-or-later
// The methods of an executable: implemented once by each unit that includes CGAL.
#pragma once

#include <span>
#include <string>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// The sum as CGAL returned it, and the seconds that the call took (without reading and writing).
struct Sum {
  Polygon region;
  double seconds;
};

struct Method {
  const char* name;
  bool holes;  ///< whether it takes polygons with holes
  Sum (*sum)(const Polygon& p, const Polygon& q);
};

std::span<const Method> methods();
std::string cgal_version();

}  // namespace minkref::cgal_oracle
