// SPDX-License-Identifier: GPL-3.0-or-later
// The solid swept by the sum while the scale grows.
#pragma once

#include <vector>

#include "oracle/cgal/triangles.hpp"

namespace minkref::cgal_oracle {

struct SolidVertex {
  mpq_class x, y, s;
};

/// Finds the vertices of {(s p + q, s) : p in P, q in Q, from <= s <= to}, a CGAL Nef polyhedron:
/// for each pair of triangles take the convex hull of the corners at both ends, and unite the
/// hulls. Interior vertices do not count, nor points where the surface is straight. Exact.
std::vector<SolidVertex> swept_solid_vertices(const std::vector<Triangle>& p,
                                              const std::vector<Triangle>& q, const mpq_class& from,
                                              const mpq_class& to);

std::string cgal_version_of_swept_solid();

}  // namespace minkref::cgal_oracle
