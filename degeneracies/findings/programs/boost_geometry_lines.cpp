// Boost.Geometry: buffer of lines, round joins and ends, 72 points per circle.
// Usage: ./boost_geometry_lines "X Y" TRUTH LINES RADIUS, TRUTH being in, out or any; lines: WKT.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>
#include <iostream>
#include <sstream>
#include <string>

namespace bg = boost::geometry;
namespace how = bg::strategy::buffer;
using Point = bg::model::d2::point_xy<double>;
using Lines = bg::model::multi_linestring<bg::model::linestring<Point>>;
using Set = bg::model::multi_polygon<bg::model::polygon<Point>>;

int main(int, char** argv) {
  const std::string truth = argv[2];
  double x, y;
  std::istringstream(argv[1]) >> x >> y;
  Lines lines;
  Set grown;
  bg::read_wkt(argv[3], lines);
  bg::buffer(lines, grown, how::distance_symmetric<double>(std::stod(argv[4])),
             how::side_straight(), how::join_round(72), how::end_round(72), how::point_circle(72));
  const std::string found = bg::within(Point(x, y), grown) ? "in" : "out";
  std::cout << "Boost " << BOOST_LIB_VERSION << ": area " << bg::area(grown) << "\n"
            << "x = (" << argv[1] << ") in the buffer: " << found << ", in truth: " << truth
            << "\n";
  return truth == "any" || truth == found ? 0 : 1;
}
