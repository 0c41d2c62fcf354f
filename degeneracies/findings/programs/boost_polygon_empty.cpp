// Boost.Polygon: the Minkowski sum of its tutorial, detail/minkowski.hpp.
// boost-polygon wrong: missing
// c++ -std=c++17 -O2 boost_polygon_empty.cpp -o boost_polygon_empty && ./boost_polygon_empty
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
    {{{0, 0}, {-133168352, 0}, {-133169152, -133169152}, {0, -133169152}},
     {{-33292288, -81381152}, {-36991432, -51788000}, {-14796576, -48088864}, {-18495712, -55487144},
      {-11097432, -85080288}},
     {{-70283720, -77682008}, {-85080288, -81381152}, {-51788000, -55487144}, {-59186288, -81381152},
      {-59186288, -66584576}}}};
const std::vector<Rings> Q{
    {{{-8388608, -8388608}, {0, 0}, {-8388608, 0}}}};

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
  const long double x = -74973184.0L, y = -70778880.0L;
  int crossings = 0, holes = 0;
  for (const Polygon& polygon : sum) {
    crossings += crossed(polygon, x, y);
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole, ++holes) {
      crossings += crossed(*hole, x, y);
    }
  }
  std::cout << "Boost " << BOOST_LIB_VERSION << ": " << sum.size() << " polygons, " << holes
            << " holes\n";
  const bool truth = true, in = crossings % 2 == 1;
  std::cout << "x = (-9371648, -8847360) in this sum: " << (in ? "in" : "out")
            << ", in truth: " << (truth ? "in" : "out") << "\n";
  return in == truth ? 0 : 1;
}
