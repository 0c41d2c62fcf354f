// CGAL, approximated_offset_2: a triangle with a vertex in the middle of its slanted side.
// g++ -std=c++17 -O2 -frounding-math cgal_offset_straight_vertex.cpp -lmpfr -lgmp && ./a.out
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/approximated_offset_2.h>
#include <CGAL/version.h>

#include <cmath>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

int main() {
  CGAL::Polygon_2<Kernel> ring;
  for (const auto& [x, y] : {std::pair{0, 0}, {2, 0}, {1, 1}, {0, 2}}) ring.push_back({x, y});
  const CGAL::Polygon_with_holes_2<Kernel> triangle(ring);
  const auto grown = CGAL::approximated_offset_2(triangle, Kernel::FT(1), 0.0005);

  // Its curves as a polygon: an arc by 20 chords.
  std::vector<std::pair<double, double>> points;
  const auto& outer = grown.outer_boundary();
  for (auto it = outer.curves_begin(); it != outer.curves_end(); ++it) {
    const double ax = CGAL::to_double(it->source().x()), ay = CGAL::to_double(it->source().y());
    const double bx = CGAL::to_double(it->target().x()), by = CGAL::to_double(it->target().y());
    points.emplace_back(ax, ay);
    if (!it->is_circular()) continue;
    const auto center = it->supporting_circle().center();
    const double cx = CGAL::to_double(center.x()), cy = CGAL::to_double(center.y());
    const double from = std::atan2(ay - cy, ax - cx), radius = std::hypot(ax - cx, ay - cy);
    double turn = std::atan2(by - cy, bx - cx) - from;
    if (it->orientation() == CGAL::COUNTERCLOCKWISE && turn < 0) turn += 2 * M_PI;
    if (it->orientation() == CGAL::CLOCKWISE && turn > 0) turn -= 2 * M_PI;
    for (int k = 1; k < 20; ++k) {
      const double at = from + turn * k / 20;
      points.emplace_back(cx + radius * std::cos(at), cy + radius * std::sin(at));
    }
  }
  double area = 0;
  bool in = false;  // whether a ray from x to the right crosses an odd number of times
  const double x = 0.0, y = 0.001;  // near the corner (0, 0), inside the triangle's hull
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [ax, ay] = points[i];
    const auto [bx, by] = points[(i + 1) % points.size()];
    area += (ax * by - ay * bx) / 2;
    if ((ay > y) != (by > y) && ax + (bx - ax) * (y - ay) / (by - ay) > x) in = !in;
  }
  std::cout << "CGAL " << CGAL_STR(CGAL_VERSION) << ": area " << area << ", it should be about "
            << 2 + 4 + std::sqrt(8.0) + M_PI << "\n"
            << "x = (0, 1/1000), a point of the set itself, in its offset: " << (in ? "in" : "out")
            << ", in truth: in\n";
  return in ? 0 : 1;
}
