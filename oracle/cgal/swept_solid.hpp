// SPDX-License-Identifier: GPL-3.0-or-later
// The solid that the sum sweeps while the scale grows.
#pragma once

#include <vector>

#include "oracle/cgal/triangles.hpp"

namespace minkref::cgal_oracle {

struct SolidVertex {
  mpq_class x, y, s;
};

/// The vertices of {(s p + q, s) : p in P, q in Q, from <= s <= to}, as a CGAL Nef polyhedron: the
/// union of one convex hull for each pair of triangles, that of the corners of both ends. Vertices
/// in its interior do not count, nor points where its surface is straight. Exact.
std::vector<SolidVertex> swept_solid_vertices(const std::vector<Triangle>& p,
                                              const std::vector<Triangle>& q, const mpq_class& from,
                                              const mpq_class& to);

std::string cgal_version_of_swept_solid();

}  // namespace minkref::cgal_oracle
