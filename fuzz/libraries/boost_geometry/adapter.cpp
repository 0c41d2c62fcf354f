// Boost.Geometry: union_ of multi-polygons in doubles, one set after the other. It has no sums.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>

#include "fuzz/adapters/adapter_protocol.hpp"

namespace minkref::adapter {
namespace {

namespace bg = boost::geometry;
using Place = bg::model::d2::point_xy<double>;
// Outer rings counter-clockwise, without the first vertex again at the end.
using Area = bg::model::polygon<Place, false, false>;
using Areas = bg::model::multi_polygon<Area>;

template <class To>
void fill(To& to, const Ring& ring) {
  for (const Point& p : ring) to.emplace_back(p.x, p.y);
}

Areas to_areas(const Polygons& polygons) {
  Areas areas;
  for (const Polygon& polygon : polygons) {
    if (polygon.outer.size() < 3) throw Skipped("no points or segments");
    Area& area = areas.emplace_back();
    fill(area.outer(), polygon.outer);
    for (const Ring& hole : polygon.holes) fill(area.inners().emplace_back(), hole);
  }
  return areas;
}

template <class From>
json ring_of(const From& from) {
  json ring = json::array();
  for (const Place& p : from) ring.push_back({p.x(), p.y()});
  return ring;
}

json unite(const std::vector<Polygons>& sets) {
  Areas all;
  for (const Polygons& set : sets) {
    Areas more;
    bg::union_(all, to_areas(set), more);
    all = std::move(more);
  }
  json polygons = json::array();
  for (const Area& area : all) {
    json holes = json::array();
    for (const auto& hole : area.inners()) holes.push_back(ring_of(hole));
    polygons.push_back({{"outer", ring_of(area.outer())}, {"holes", holes}});
  }
  return {{"polygons", polygons}};
}

json hello() {
  const std::string version = std::to_string(BOOST_VERSION / 100000) + "." +
                              std::to_string(BOOST_VERSION / 100 % 1000) + "." +
                              std::to_string(BOOST_VERSION % 100);
  // Up to 1.79 it decides on a grid of 10^7 units for the whole extent (get_rescale_policy), so
  // that features within some units merge, each time again: ten units.
  return {{"name", "boost-geometry"},
          {"version", version},
          {"language", "C++"},
          {"sum", "none"},
          {"numbers", "double"},
          {"arithmetic", "float64"},
          {"tolerance", {{"absolute", "0"}, {"relative", "1e-6"}}},
          {"capabilities",
           {"plane", "non-convex", "holes", "components", "touching", "empty", "union"}}};
}

}  // namespace
}  // namespace minkref::adapter

int main() {
  using namespace minkref::adapter;
  return serve(hello(), {nullptr, unite});
}
