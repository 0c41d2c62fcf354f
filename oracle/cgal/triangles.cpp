// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/triangles.hpp"

#include "oracle/cgal/nesting.hpp"

namespace minkref::cgal_oracle {
namespace {

using Triangulation = NestedTriangulation<CGAL::Triangulation_vertex_base_2<Kernel>>;

void insert_ring(const Ring& ring, Triangulation& triangulation) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    triangulation.insert_constraint(Kernel::Point_2(to_cgal(a.x), to_cgal(a.y)),
                                    Kernel::Point_2(to_cgal(b.x), to_cgal(b.y)));
  }
}

}  // namespace

std::vector<Triangle> triangles(const std::vector<Polygon>& polygons) {
  Triangulation triangulation;
  for (const Polygon& polygon : polygons) {
    insert_ring(polygon.outer, triangulation);
    for (const Ring& hole : polygon.holes) insert_ring(hole, triangulation);
  }
  std::vector<Triangle> result;
  if (triangulation.dimension() < 2) return result;
  count_rings(triangulation);
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
       ++face) {
    if (face->info().rings_around % 2 == 0) continue;
    Triangle triangle;
    for (int i = 0; i < 3; ++i) {
      const auto& p = face->vertex(i)->point();
      triangle[static_cast<std::size_t>(i)] = {from_cgal(p.x()), from_cgal(p.y())};
    }
    result.push_back(std::move(triangle));
  }
  return result;
}

}  // namespace minkref::cgal_oracle
