// Boost.Polygon: the Minkowski sum of its tutorial, detail/minkowski.hpp.
// boost-polygon wrong: hole-lost
// c++ -std=c++17 -O2 boost_polygon_hole.cpp -o boost_polygon_hole && ./boost_polygon_hole
#include <boost/polygon/polygon.hpp>
#include <boost/version.hpp>

#include <iostream>
#include <vector>

namespace bp = boost::polygon;
using Point = bp::point_data<int>;
using Polygon = bp::polygon_with_holes_data<int>;
using Set = bp::polygon_set_data<int>;
using Rings = std::vector<std::vector<Point>>;  // outer ring, holes

// Coordinates times 2^3, rounded.
const std::vector<Rings> P{
    {{{0, 41943040}, {-8387808, 33553392}, {-25165824, 0}}}};
const std::vector<Rings> Q{
    {{{-125829120, -8388608}, {8, -8388608}, {8, 100663296}},
     {{0, 62914560}, {-25165824, 12582912}, {-37748736, 0}},
     {{-58720256, 41943080}, {-75497488, 8388616}, {-83886104, 0}}}};

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
  const long double x = -35913696.0L, y = 44302384.0L;
  int crossings = 0, holes = 0;
  for (const Polygon& polygon : sum) {
    crossings += crossed(polygon, x, y);
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole, ++holes) {
      crossings += crossed(*hole, x, y);
    }
  }
  std::cout << "Boost " << BOOST_LIB_VERSION << ": " << sum.size() << " polygons, " << holes
            << " holes\n";
  const bool truth = false, in = crossings % 2 == 1;
  std::cout << "x = (-4489212, 5537798) in this sum: " << (in ? "in" : "out")
            << ", in truth: " << (truth ? "in" : "out") << "\n";
  return in == truth ? 0 : 1;
}
