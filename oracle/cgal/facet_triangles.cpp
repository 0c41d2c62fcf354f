// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/facet_triangles.hpp"

#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "oracle/cgal/nesting.hpp"

namespace minkref::cgal_oracle {
namespace {

using Triangulation =
    NestedTriangulation<CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>>;

/// Projects along the axis of the largest normal component; counter-clockwise stays
/// counter-clockwise.
Kernel::Point_2 flat(const SpacePoint& p, const SpacePoint& normal) {
  const mpq_class x = abs(normal.x), y = abs(normal.y), z = abs(normal.z);
  const auto point = [](const mpq_class& a, const mpq_class& b, bool keep) {
    return keep ? Kernel::Point_2(to_cgal(a), to_cgal(b)) : Kernel::Point_2(to_cgal(b), to_cgal(a));
  };
  if (x >= y && x >= z) return point(p.y, p.z, normal.x > 0);
  if (y >= z) return point(p.z, p.x, normal.y > 0);
  return point(p.x, p.y, normal.z > 0);
}

}  // namespace

void triangulate_facet(const std::vector<SpacePoint>& vertices, const std::vector<Face>& cycles,
                       const SpacePoint& normal, std::vector<Face>& triangles) {
  if (cycles.size() == 1 && cycles[0].size() == 3) {
    triangles.push_back(cycles[0]);
    if (CGAL::orientation(flat(vertices[cycles[0][0]], normal),
                          flat(vertices[cycles[0][1]], normal),
                          flat(vertices[cycles[0][2]], normal)) == CGAL::RIGHT_TURN) {
      std::swap(triangles.back()[0], triangles.back()[1]);
    }
    return;
  }
  Triangulation triangulation;
  for (const Face& cycle : cycles) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (const std::size_t i : cycle) {
      handles.push_back(triangulation.insert(flat(vertices[i], normal)));
      handles.back()->info() = i;
    }
    for (std::size_t i = 0; i < handles.size(); ++i) {
      const auto next = handles[(i + 1) % handles.size()];
      if (handles[i] != next) triangulation.insert_constraint(handles[i], next);
    }
  }
  if (triangulation.dimension() < 2) return;
  count_rings(triangulation);
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    if (f->info().rings_around % 2 == 0) continue;
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }
}

}  // namespace minkref::cgal_oracle
