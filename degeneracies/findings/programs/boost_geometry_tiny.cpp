// Boost.Geometry: union_ of one set after the other.
// boost-geometry wrong: missing
// c++ -std=c++17 -O2 boost_geometry_tiny.cpp -o boost_geometry_tiny && ./boost_geometry_tiny
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>

#include <iostream>
#include <vector>

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false, false>;
using Set = bg::model::multi_polygon<Polygon>;
using Rings = std::vector<std::vector<Point>>;  // outer ring, holes

const std::vector<std::vector<Rings>> sets{
    {{{{0.0, 6.366462912410498e-12}, {0.0, 0.0}, {5.21977199241519e-08, 0.0}}}},
    {{{{0.0, 9.094947017729282e-13}, {0.0, 0.0}, {5.219953891355544e-08, 0.0}}}}};

Set to_set(const std::vector<Rings>& polygons) {
  Set set;
  for (const Rings& rings : polygons) {
    Polygon polygon;
    polygon.outer().assign(rings[0].begin(), rings[0].end());
    for (std::size_t k = 1; k < rings.size(); ++k) {
      polygon.inners().emplace_back(rings[k].begin(), rings[k].end());
    }
    set.push_back(polygon);
  }
  return set;
}

// How often the ray from x to the right crosses the ring.
template <class Ring>
int crossed(const Ring& ring, long double x, long double y) {
  int count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const long double t = (y - a.y()) / (static_cast<long double>(b.y()) - a.y());
    if (a.x() + t * (static_cast<long double>(b.x()) - a.x()) > x) ++count;
  }
  return count;
}

int main() {
  Set all;
  for (const auto& set : sets) {
    Set more;
    bg::union_(all, to_set(set), more);
    all = more;
  }
  const long double x = 6174313861.0L / 240518168576000000.0L, y = 20416555469.0L / 12620634268264038400000.0L;
  int crossings = 0;
  for (const Polygon& polygon : all) {
    crossings += crossed(polygon.outer(), x, y);
    for (const auto& hole : polygon.inners()) crossings += crossed(hole, x, y);
  }
  std::cout.precision(17);
  std::cout << "Boost " << BOOST_LIB_VERSION << ": " << bg::wkt(all) << "\n";
  const bool truth = true, in = crossings % 2 == 1;
  std::cout << "x = (6174313861/240518168576000000, 20416555469/12620634268264038400000) in this union: " << (in ? "in" : "out")
            << ", in truth: " << (truth ? "in" : "out") << "\n";
  return in == truth ? 0 : 1;
}
