// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <chrono>
#include <map>

#include "oracle/cgal/kernel.hpp"
#include "oracle/cgal/solid.hpp"

namespace minkref::cgal_oracle {
namespace {

std::vector<Kernel::Vector_3> vectors_of(const Solid& solid) {
  std::vector<Kernel::Vector_3> result;
  for (const SpacePoint& v : solid.vertices) {
    result.emplace_back(to_cgal(v.x), to_cgal(v.y), to_cgal(v.z));
  }
  return result;
}

}  // namespace

Solid hull_of_sums(const Solid& p, const Solid& q) {
  const std::vector<Kernel::Vector_3> first = vectors_of(p), second = vectors_of(q);
  const auto start = std::chrono::steady_clock::now();
  std::vector<Kernel::Point_3> points;
  points.reserve(first.size() * second.size());
  for (const Kernel::Vector_3& a : first) {
    for (const Kernel::Vector_3& b : second) points.push_back(CGAL::ORIGIN + (a + b));
  }
  CGAL::Polyhedron_3<Kernel> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  Solid result;
  result.seconds = taken.count();
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
