// Boost.Geometry: buffer with round joins, of a quadrilateral with a reflex vertex, far from 1.
// c++ -std=c++17 -O2 boost_geometry_buffer_reflex.cpp && ./a.out
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>

#include <cmath>
#include <iostream>

namespace bg = boost::geometry;
namespace how = bg::strategy::buffer;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false, false>;
using Set = bg::model::multi_polygon<Polygon>;

const Polygon set{{{2147483649, 4294967296}, {2147483648, 1}, {0, 3221225453}, {2147483648, 0}}};
const double radius = 7110873;
const Point x(0, 4294967296);
const bool truth = false;  // its distance from (0, 3221225453) is 1073741843, far beyond the radius

int main() {
  Set grown;
  bg::buffer(set, grown, how::distance_symmetric<double>(radius), how::side_straight(),
             how::join_round(72), how::end_round(72), how::point_circle(72));
  const bool in = bg::within(x, grown);
  std::cout << "Boost " << BOOST_LIB_VERSION << ": area " << bg::area(grown)
            << "" << "\n"
            << "x = (" << x.x() << ", " << x.y() << ") in the buffer: " << (in ? "in" : "out")
            << ", in truth: " << (truth ? "in" : "out") << "\n";
  return in == truth ? 0 : 1;
}
