// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/triangles.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <deque>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {
namespace {

struct Nesting {
  int rings_around = -1;  ///< unknown
};
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Nesting, Kernel>>;
using Structure =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

void insert_ring(const Ring& ring, Triangulation& triangulation) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    triangulation.insert_constraint(Kernel::Point_2(to_cgal(a.x), to_cgal(a.y)),
                                    Kernel::Point_2(to_cgal(b.x), to_cgal(b.y)));
  }
}

/// From the outside inwards, one more ring across each constraint.
void count_rings(Triangulation& triangulation) {
  std::deque<Triangulation::Face_handle> queue{triangulation.infinite_face()};
  queue.front()->info().rings_around = 0;
  while (!queue.empty()) {
    const auto face = queue.front();
    queue.pop_front();
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->info().rings_around >= 0) continue;
      const bool across = face->is_constrained(i);
      next->info().rings_around = face->info().rings_around + (across ? 1 : 0);
      if (across) {
        queue.push_back(next);
      } else {
        queue.push_front(next);
      }
    }
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
