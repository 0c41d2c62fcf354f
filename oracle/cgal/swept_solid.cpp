// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/swept_solid.hpp"

#include <CGAL/Nef_nary_union_3.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {
namespace {

using Solid = CGAL::Nef_polyhedron_3<Kernel>;

Solid swept_triangles(const Triangle& p, const Triangle& q, const mpq_class& from,
                      const mpq_class& to) {
  std::vector<Kernel::Point_3> points;
  for (const mpq_class& s : {from, to}) {
    for (const Point& a : p) {
      for (const Point& b : q) {
        points.emplace_back(to_cgal(mpq_class(s * a.x + b.x)), to_cgal(mpq_class(s * a.y + b.y)),
                            to_cgal(s));
      }
    }
  }
  CGAL::Polyhedron_3<Kernel> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return Solid(hull);
}

}  // namespace

std::vector<SolidVertex> swept_solid_vertices(const std::vector<Triangle>& p,
                                              const std::vector<Triangle>& q, const mpq_class& from,
                                              const mpq_class& to) {
  CGAL::Nef_nary_union_3<Solid> unite;
  for (const Triangle& a : p) {
    for (const Triangle& b : q) unite.add_polyhedron(swept_triangles(a, b, from, to));
  }
  const Solid solid = unite.get_union().regularization();
  std::vector<SolidVertex> vertices;
  for (auto v = solid.vertices_begin(); v != solid.vertices_end(); ++v) {
    const auto& point = v->point();
    vertices.push_back({from_cgal(point.x()), from_cgal(point.y()), from_cgal(point.z())});
  }
  return vertices;
}

std::string cgal_version_of_swept_solid() { return CGAL_VERSION_STR; }

}  // namespace minkref::cgal_oracle
