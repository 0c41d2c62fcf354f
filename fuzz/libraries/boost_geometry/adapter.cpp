// Boost.Geometry, in two ways: the argument is union or buffer. It has no sums.
//
// union: union_ of multi-polygons in doubles, one set after the other.
//
// buffer: buffer with round or mitred joins, round or flat ends, 72 points for a circle: the
// polygon of an arc is off by 1 - cos(pi / 72) = 0.00095 of the radius. The input is simplified by
// a thousandth of the radius before (simplify_distance).
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/version.hpp>
#include <string_view>

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

json written(const Areas& all) {
  json polygons = json::array();
  for (const Area& area : all) {
    json holes = json::array();
    for (const auto& hole : area.inners()) holes.push_back(ring_of(hole));
    polygons.push_back({{"outer", ring_of(area.outer())}, {"holes", holes}});
  }
  return {{"polygons", polygons}};
}

constexpr std::size_t points_per_circle = 72;

namespace how = bg::strategy::buffer;
using Line = bg::model::linestring<Place>;
using Lines = bg::model::multi_linestring<Line>;

/// Round or mitred corners, chosen at run time: each pair of strategies takes long to compile.
struct Join {
  how::join_round round;
  how::join_miter mitre;
  bool is_mitre;

  template <class P, class Distance, class Out>
  bool apply(const P& tip, const P& vertex, const P& from, const P& to, const Distance& distance,
             Out& out) const {
    return is_mitre ? mitre.apply(tip, vertex, from, to, distance, out)
                    : round.apply(tip, vertex, from, to, distance, out);
  }
  template <class Number>
  Number max_distance(const Number& distance) const {
    return is_mitre ? mitre.max_distance(distance) : round.max_distance(distance);
  }
};

/// Round or flat ends, likewise.
struct End {
  how::end_round round;
  how::end_flat flat;
  bool is_flat;

  template <class P, class Out, class Distance>
  void apply(const P& before, const P& left, const P& last, const P& right,
             how::buffer_side_selector side, const Distance& distance, Out& out) const {
    if (is_flat) {
      flat.apply(before, left, last, right, side, distance, out);
    } else {
      round.apply(before, left, last, right, side, distance, out);
    }
  }
  template <class Number>
  Number max_distance(const Number& distance) const {
    return distance;
  }
  how::piece_type get_piece_type() const {
    return is_flat ? how::buffered_flat_end : how::buffered_round_end;
  }
};

template <class Geometry>
json buffered(const Geometry& from, const Growth& asked) {
  Areas all;
  bg::buffer(
      from, all, how::distance_symmetric<double>(asked.radius), how::side_straight(),
      Join{how::join_round(points_per_circle), how::join_miter(asked.limit), asked.join == "mitre"},
      End{how::end_round(points_per_circle), how::end_flat(), asked.cap == "flat"},
      how::point_circle(points_per_circle));
  return written(all);
}

json grow(const Growth& asked) {
  if (!asked.lines.empty()) {
    Lines lines;
    for (const Ring& line : asked.lines) fill(lines.emplace_back(), line);
    return buffered(lines, asked);
  }
  const Polygons& P = asked.polygons;
  if (P.size() != 1 || P[0].outer.size() > 2) return buffered(to_areas(P), asked);
  const Ring& ring = P[0].outer;
  if (ring.size() == 1) return buffered(Place(ring[0].x, ring[0].y), asked);
  Lines line;
  fill(line.emplace_back(), ring);
  return buffered(line, asked);
}

json unite(const std::vector<Polygons>& sets) {
  Areas all;
  for (const Polygons& set : sets) {
    Areas more;
    bg::union_(all, to_areas(set), more);
    all = std::move(more);
  }
  return written(all);
}

json hello(const char* name) {
  const std::string version = std::to_string(BOOST_VERSION / 100000) + "." +
                              std::to_string(BOOST_VERSION / 100 % 1000) + "." +
                              std::to_string(BOOST_VERSION % 100);
  // Up to 1.79 it decides on a grid of 10^7 units for the whole extent (get_rescale_policy), so
  // that features within some units merge, each time again: ten units.
  return {{"name", name},
          {"version", version},
          {"language", "C++"},
          {"sum", "none"},
          {"numbers", "double"},
          {"arithmetic", "float64"},
          {"tolerance", {{"absolute", "0"}, {"relative", "1e-6"}}},
          {"capabilities", {"plane", "non-convex", "holes", "components", "touching", "empty"}}};
}

int run(std::string_view mode) {
  if (mode == "union") {
    json value = hello("boost-geometry");
    value["capabilities"].push_back("union");
    return serve(value, {nullptr, unite});
  }
  if (mode == "buffer") {
    json value = hello("boost-geometry-buffer");
    value["tolerance"]["radius"] = "0.00196";
    for (const char* more :
         {"point", "segment", "offset", "inset", "line-offset", "join-mitre", "cap-flat"}) {
      value["capabilities"].push_back(more);
    }
    return serve(value, {nullptr, nullptr, nullptr, grow});
  }
  std::cerr << "usage: boost_geometry_adapter union|buffer\n";
  return 2;
}

}  // namespace
}  // namespace minkref::adapter

int main(int count, char** arguments) {
  return minkref::adapter::run(count > 1 ? arguments[1] : "");
}
