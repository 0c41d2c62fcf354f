// SPDX-License-Identifier: GPL-3.0-or-later
// Sets in space, and two ways to sum them by CGAL. No CGAL here.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace minkref::cgal_oracle {

struct SpacePoint {
  mpq_class x, y, z;
};

using Face = std::vector<std::size_t>;  ///< indices of vertices

/// A closed surface: each planar face runs counter-clockwise seen from outside. An operand's shells
/// share no vertex; a sum's shells may touch along edges and at vertices.
struct Solid {
  std::vector<SpacePoint> vertices;
  std::vector<Face> faces;
  double seconds = 0;  ///< of a sum: CGAL's time, with operands already in CGAL's form
};

/// Calls minkowski_sum_3 on Nef polyhedra. The faces are triangles. Exact. Throws BadOperand for a
/// shell that is no closed surface to CGAL.
Solid sum_of_nef_polyhedra(const Solid& p, const Solid& q);

/// Computes the convex hull of all vertex sums: convex operands' sum. Exact.
Solid hull_of_sums(const Solid& p, const Solid& q);

std::string cgal_version_of_nef();

}  // namespace minkref::cgal_oracle
