// SPDX-License-Identifier: GPL-3.0-or-later
// An executable's methods; each compilation unit that includes CGAL implements them once.
#pragma once

#include <span>
#include <string>

#include "oracle/cgal/polygon.hpp"

namespace minkref::cgal_oracle {

/// The sum as CGAL returned it, and the call's seconds, without reading and writing.
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
