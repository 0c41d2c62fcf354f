// Boost.Geometry: union_, set after set.
// Usage: ./boost_geometry_union "X Y" TRUTH SET..., TRUTH being in, out or any (crashes); sets:
// WKT.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>
#include <iostream>
#include <sstream>
#include <string>

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false, false>;
using Set = bg::model::multi_polygon<Polygon>;

// Crossings between the ring and a ray to the right.
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

int main(int count, char** argv) {
  const std::string truth = argv[2];
  Set all;
  for (int k = 3; k < count; ++k) {
    Set set, more;
    bg::read_wkt(argv[k], set);
    bg::correct(set);
    bg::union_(all, set, more);
    all = more;
  }
  long double x, y;
  std::istringstream(argv[1]) >> x >> y;
  int crossings = 0;
  for (const Polygon& polygon : all) {
    crossings += crossed(polygon.outer(), x, y);
    for (const auto& hole : polygon.inners()) crossings += crossed(hole, x, y);
  }
  const std::string found = crossings % 2 == 1 ? "in" : "out";
  std::cout.precision(17);
  std::cout << "Boost " << BOOST_LIB_VERSION << ": " << bg::wkt(all) << "\n"
            << "x = (" << argv[1] << ") in this union: " << found << ", in truth: " << truth
            << "\n";
  return truth == "any" || truth == found ? 0 : 1;
}
