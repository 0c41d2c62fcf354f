// SPDX-License-Identifier: GPL-3.0-or-later
// Sets in space and the two ways in which CGAL sums them. No CGAL here.
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

/// A closed surface: each planar face runs counter-clockwise seen from outside. The shells of an
/// operand share no vertex; those of a sum may touch along edges and at vertices.
struct Solid {
  std::vector<SpacePoint> vertices;
  std::vector<Face> faces;
  double seconds = 0;  ///< of a sum: what CGAL took, its operands being in its own form
};

/// By minkowski_sum_3 of Nef polyhedra. The faces are triangles. Exact. Throws BadOperand where a
/// shell is no closed surface that CGAL takes.
Solid sum_of_nef_polyhedra(const Solid& p, const Solid& q);

/// The convex hull of the sums of all pairs of vertices: the sum where both are convex. Exact.
Solid hull_of_sums(const Solid& p, const Solid& q);

std::string cgal_version_of_nef();

}  // namespace minkref::cgal_oracle
