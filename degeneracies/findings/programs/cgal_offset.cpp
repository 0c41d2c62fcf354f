// CGAL: approximated_offset_2, epsilon RADIUS / 2000.
// Usage: ./cgal_offset "X Y" TRUTH P RADIUS, TRUTH being in, out or any (crashes).
// P, as CGAL reads it: vertex count, coordinates, hole count, holes likewise.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/approximated_offset_2.h>
#include <CGAL/version.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Set = CGAL::Polygon_with_holes_2<Kernel>;
using Points = std::vector<std::pair<double, double>>;

template <class Value>
Value read(const std::string& text) {
  std::istringstream stream(text + "\n");
  Value value;
  if (!(stream >> value)) throw std::runtime_error("cannot read " + text);
  return value;
}

// Ring as polygon, 20 chords per arc.
template <class Ring>
Points points_of(const Ring& ring) {
  Points points;
  for (auto it = ring.curves_begin(); it != ring.curves_end(); ++it) {
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
  return points;
}

// Parity along a ray to the right.
bool odd(const Points& points, double x, double y) {
  bool in = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [ax, ay] = points[i];
    const auto [bx, by] = points[(i + 1) % points.size()];
    if ((ay > y) != (by > y) && ax + (bx - ax) * (y - ay) / (by - ay) > x) in = !in;
  }
  return in;
}

int main(int, char** argv) {
  const auto x = read<Kernel::Point_2>(argv[1]);
  const std::string truth = argv[2];
  const auto radius = read<Kernel::FT>(argv[4]);
  const auto grown =
      CGAL::approximated_offset_2(read<Set>(argv[3]), radius, CGAL::to_double(radius) / 2000);
  const double at[] = {CGAL::to_double(x.x()), CGAL::to_double(x.y())};
  bool in = odd(points_of(grown.outer_boundary()), at[0], at[1]);
  for (auto hole = grown.holes_begin(); hole != grown.holes_end(); ++hole) {
    in = in != odd(points_of(*hole), at[0], at[1]);
  }
  const std::string found = in ? "in" : "out";
  std::cout << "CGAL " << CGAL_STR(CGAL_VERSION) << ": " << grown.number_of_holes() << " holes\n"
            << "x = (" << argv[1] << ") in the offset: " << found << ", in truth: " << truth
            << std::endl;
  return truth == "any" || truth == found ? 0 : 1;
}
