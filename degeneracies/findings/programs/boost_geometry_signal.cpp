// Boost.Geometry: union_ of one set after the other.
// boost-geometry crashed: crashed
// c++ -std=c++17 -O2 boost_geometry_signal.cpp -o boost_geometry_signal && ./boost_geometry_signal
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
    {{{{0.0, 676457349120.0}, {445602856960.0, 688268509184.0}, {231928233984.0, 98784247808.0}, {842887331824.0, 161061273600.0}, {294205259776.0, 1042603311104.0}}}},
    {{{{842887331824.0, 0.0}, {46170898432.0, 417685569536.0}, {263066746880.0, 0.0}}}},
    {{{{511101108224.0, 886910746624.0}, {123480309760.0, 383325831168.0}, {350039834624.0, 0.0}}}}};

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
  const long double x = 0.0L, y = 0.0L;
  int crossings = 0;
  for (const Polygon& polygon : all) {
    crossings += crossed(polygon.outer(), x, y);
    for (const auto& hole : polygon.inners()) crossings += crossed(hole, x, y);
  }
  std::cout.precision(17);
  std::cout << "Boost " << BOOST_LIB_VERSION << ": " << bg::wkt(all) << "\n";
  const bool truth = false, in = truth;
  std::cout << "x = (0, 0) in this union: " << (in ? "in" : "out")
            << ", in truth: " << (truth ? "in" : "out") << "\n";
  return in == truth ? 0 : 1;
}
