// Boost.Polygon: Minkowski sums by detail/minkowski.hpp.
// Usage: ./boost_polygon_sum "X Y" TRUTH P Q, TRUTH being in, out or any (crashes).
// Operands: vertex count, coordinates, hole count, holes likewise.
#include <boost/polygon/polygon.hpp>
#include <boost/version.hpp>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace bp = boost::polygon;
using Ring = bp::polygon_data<int>;
using Polygon = bp::polygon_with_holes_data<int>;
using Set = bp::polygon_set_data<int>;

Ring ring_of(std::istream& text) {
  int count = 0, x = 0, y = 0;
  std::vector<bp::point_data<int>> points;
  for (text >> count; count > 0 && text >> x >> y; --count) points.emplace_back(x, y);
  return Ring(points.begin(), points.end());
}

Set set_of(const char* argument) {
  std::istringstream text(argument);
  const Ring outer = ring_of(text);
  int count = 0;
  text >> count;
  std::vector<Ring> holes;
  while (count-- > 0) holes.push_back(ring_of(text));
  Polygon polygon;
  polygon.set(outer.begin(), outer.end());
  polygon.set_holes(holes.begin(), holes.end());
  Set set;
  set.insert(polygon);
  return set;
}

// Crossings between the ring and a ray to the right.
template <class Any>
int crossed(const Any& ring, long double x, long double y) {
  const std::vector<bp::point_data<int>> points(ring.begin(), ring.end());
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto a = points[i], b = points[(i + 1) % points.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const long double t = (y - a.y()) / (static_cast<long double>(b.y()) - a.y());
    if (a.x() + t * (static_cast<long double>(b.x()) - a.x()) > x) ++count;
  }
  return count;
}

int main(int, char** argv) {
  const std::string truth = argv[2];
  Set set;
  bp::detail::minkowski_offset<int>::convolve_two_polygon_sets(set, set_of(argv[3]),
                                                               set_of(argv[4]));
  std::vector<Polygon> sum;
  set.get(sum);
  long double x, y;
  std::istringstream(argv[1]) >> x >> y;
  int crossings = 0, holes = 0;
  for (const Polygon& polygon : sum) {
    crossings += crossed(polygon, x, y);
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole, ++holes) {
      crossings += crossed(*hole, x, y);
    }
  }
  const std::string found = crossings % 2 == 1 ? "in" : "out";
  std::cout << "Boost " << BOOST_LIB_VERSION << ": " << sum.size() << " polygons, " << holes
            << " holes\nx = (" << argv[1] << ") in this sum: " << found << ", in truth: " << truth
            << "\n";
  return truth == "any" || truth == found ? 0 : 1;
}
