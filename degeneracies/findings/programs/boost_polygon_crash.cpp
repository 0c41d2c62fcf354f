// Boost.Polygon: the Minkowski sum of its tutorial, detail/minkowski.hpp.
// boost-polygon crashed: crashed, SIGSEGV
// c++ -std=c++17 -O2 boost_polygon_crash.cpp -o boost_polygon_crash && ./boost_polygon_crash
#include <boost/polygon/polygon.hpp>
#include <boost/version.hpp>

#include <iostream>
#include <vector>

namespace bp = boost::polygon;
using Point = bp::point_data<int>;
using Polygon = bp::polygon_with_holes_data<int>;
using Set = bp::polygon_set_data<int>;
using Rings = std::vector<std::vector<Point>>;  // outer ring, holes

// Coordinates times 2^4, rounded.
const std::vector<Rings> P{
    {{{-141902000, 0}, {0, -141907280}, {141907280, 0}, {0, 141907280}},
     {{-96496960, 0}, {0, 96496960}, {96496960, 0}}}};
const std::vector<Rings> Q{
    {{{0, 28381456}, {-28381456, 0}, {0, -28381456}}}};

Set to_set(const std::vector<Rings>& polygons) {
  Set set;
  for (const Rings& rings : polygons) {
    Polygon polygon;
    polygon.set(rings[0].begin(), rings[0].end());
    std::vector<bp::polygon_data<int>> holes;
    for (std::size_t k = 1; k < rings.size(); ++k) {
      holes.emplace_back(rings[k].begin(), rings[k].end());
    }
    polygon.set_holes(holes.begin(), holes.end());
    set.insert(polygon);
  }
  return set;
}

// How often the ray from x to the right crosses the ring.
template <class Ring>
int crossed(const Ring& ring, long double x, long double y) {
  const std::vector<Point> points(ring.begin(), ring.end());
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point a = points[i], b = points[(i + 1) % points.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const long double t = (y - a.y()) / (static_cast<long double>(b.y()) - a.y());
    if (a.x() + t * (static_cast<long double>(b.x()) - a.x()) > x) ++count;
  }
  return count;
}

int main() {
  Set set;
  bp::detail::minkowski_offset<int>::convolve_two_polygon_sets(set, to_set(P), to_set(Q));
  std::vector<Polygon> sum;
  set.get(sum);
  const long double x = 0.0L, y = 0.0L;
  int crossings = 0, holes = 0;
  for (const Polygon& polygon : sum) {
    crossings += crossed(polygon, x, y);
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole, ++holes) {
      crossings += crossed(*hole, x, y);
    }
  }
  std::cout << "Boost " << BOOST_LIB_VERSION << ": " << sum.size() << " polygons, " << holes
            << " holes\n";
  const bool truth = false, in = truth;
  std::cout << "x = (0, 0) in this sum: " << (in ? "in" : "out")
            << ", in truth: " << (truth ? "in" : "out") << "\n";
  return in == truth ? 0 : 1;
}
