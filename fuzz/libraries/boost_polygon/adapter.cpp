// Boost.Polygon: the sum of polygon sets by its tutorial ("Minkowski sum of polygons"), which the
// library also contains as detail/minkowski.hpp: a quadrilateral for each pair of edges, the
// translates of each polygon by a vertex of the other, and their union by the Boolean operations.
// Sets to unite go into one set, whose polygons the same operations find.
// clipper2/adapter.cpp explains why this gives the whole sum, also with holes.
#include <boost/polygon/polygon.hpp>
#include <boost/version.hpp>

#include "fuzz/adapters/integer_grid.hpp"

namespace minkref::adapter {
namespace {

namespace bp = boost::polygon;
using GridPoint = bp::point_data<int>;
using GridPolygon = bp::polygon_with_holes_data<int>;
using GridSet = bp::polygon_set_data<int>;

// Coordinates are 32-bit integers, with a factor of four left for differences.
constexpr int bits = 28;

std::vector<GridPoint> to_points(const Ring& ring, const IntegerGrid& grid) {
  std::vector<GridPoint> points;
  for (const Point& p : ring) {
    points.emplace_back(static_cast<int>(grid.to_grid(p.x)), static_cast<int>(grid.to_grid(p.y)));
  }
  return points;
}

GridSet to_set(const Polygons& polygons, const IntegerGrid& grid) {
  GridSet set;
  for (const Polygon& polygon : polygons) {
    if (polygon.outer.size() < 3) throw Skipped("no points or segments");
    const auto outer = to_points(polygon.outer, grid);
    GridPolygon item;
    item.set(outer.begin(), outer.end());
    std::vector<bp::polygon_data<int>> holes;
    for (const Ring& hole : polygon.holes) {
      const auto points = to_points(hole, grid);
      holes.emplace_back(points.begin(), points.end());
    }
    item.set_holes(holes.begin(), holes.end());
    set.insert(item);
  }
  return set;
}

template <class Item>
json ring_of(const Item& item, const IntegerGrid& grid) {
  json ring = json::array();
  for (auto p = item.begin(); p != item.end(); ++p) {
    ring.push_back({grid.from_grid(p->x()), grid.from_grid(p->y())});
  }
  // Boost repeats the first vertex at the end.
  if (ring.size() > 1 && ring.front() == ring.back()) ring.erase(ring.size() - 1);
  return ring;
}

json result_of(const GridSet& set, const IntegerGrid& grid) {
  std::vector<GridPolygon> result;
  set.get(result);
  json polygons = json::array();
  for (const GridPolygon& polygon : result) {
    json holes = json::array();
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole) {
      holes.push_back(ring_of(*hole, grid));
    }
    polygons.push_back({{"outer", ring_of(polygon, grid)}, {"holes", holes}});
  }
  return {{"polygons", polygons}};
}

json sum(const Polygons& sP, const Polygons& Q) {
  const IntegerGrid grid(sP, Q, bits);
  GridSet set;
  bp::detail::minkowski_offset<int>::convolve_two_polygon_sets(set, to_set(sP, grid),
                                                               to_set(Q, grid));
  return result_of(set, grid);
}

json unite(const std::vector<Polygons>& sets) {
  double size = 0;
  for (const Polygons& set : sets) size = std::max(size, largest_coordinate(set));
  const IntegerGrid grid(size, bits);
  GridSet all;
  for (const Polygons& set : sets) all.insert(to_set(set, grid));
  return result_of(all, grid);
}

json hello() {
  const std::string version = std::to_string(BOOST_VERSION / 100000) + "." +
                              std::to_string(BOOST_VERSION / 100 % 1000) + "." +
                              std::to_string(BOOST_VERSION % 100);
  // The operations snap intersections to the grid, and edges to vertices within a unit, which moves
  // edges sideways by up to a unit each time. The operands are united before the sum, the sum
  // after: eight units of 2^-27.
  return {{"name", "boost-polygon"},
          {"version", version},
          {"language", "C++"},
          {"sum", "region"},
          {"numbers", "double"},
          {"arithmetic", "integer-grid"},
          {"grid", {{"bits", bits - 2}}},
          {"tolerance", {{"absolute", "0"}, {"relative", "1/16777216"}}},
          {"capabilities", {"plane", "non-convex", "holes", "components", "touching", "union"}}};
}

}  // namespace
}  // namespace minkref::adapter

int main() {
  using namespace minkref::adapter;
  return serve(hello(), {sum, unite});
}
