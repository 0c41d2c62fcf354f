// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the rings around each face of a triangulation.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <deque>

#include "oracle/cgal/kernel.hpp"

namespace minkref::cgal_oracle {

struct Nesting {
  int rings_around = -1;  ///< unknown
};
using NestedFace = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Nesting, Kernel>>;
template <class Vertex>
using NestedTriangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertex, NestedFace>>;

/// Counts from the outside inwards, one more ring across each constraint.
template <class Triangulation>
void count_rings(Triangulation& triangulation) {
  std::deque<typename Triangulation::Face_handle> queue{triangulation.infinite_face()};
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

}  // namespace minkref::cgal_oracle
