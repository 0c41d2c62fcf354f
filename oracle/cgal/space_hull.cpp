// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <map>

#include "oracle/cgal/kernel.hpp"
#include "oracle/cgal/solid.hpp"

namespace minkref::cgal_oracle {

Solid hull_of_sums(const Solid& p, const Solid& q) {
  std::vector<Kernel::Point_3> points;
  for (const SpacePoint& a : p.vertices) {
    for (const SpacePoint& b : q.vertices) {
      points.emplace_back(to_cgal(mpq_class(a.x + b.x)), to_cgal(mpq_class(a.y + b.y)),
                          to_cgal(mpq_class(a.z + b.z)));
    }
  }
  CGAL::Polyhedron_3<Kernel> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  Solid result;
  std::map<const void*, std::size_t> numbers;
  for (auto v = hull.vertices_begin(); v != hull.vertices_end(); ++v) {
    numbers[&*v] = result.vertices.size();
    const auto& point = v->point();
    result.vertices.push_back({from_cgal(point.x()), from_cgal(point.y()), from_cgal(point.z())});
  }
  for (auto f = hull.facets_begin(); f != hull.facets_end(); ++f) {
    Face& face = result.faces.emplace_back();
    auto h = f->facet_begin();
    do {
      face.push_back(numbers.at(&*h->vertex()));
    } while (++h != f->facet_begin());
  }
  return result;
}

}  // namespace minkref::cgal_oracle
