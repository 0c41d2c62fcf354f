#include "formats/coordinate_lists.hpp"
#include "formats/write.hpp"
#include "reference/plane/lines.hpp"

namespace minkref {
namespace {

std::string geometry(const std::string& type, const std::string& coordinates) {
  return "{\"type\":\"" + type + "\",\"coordinates\":" + coordinates + "}\n";
}

/// One type of geometry if all parts are points, or all segments; else a collection.
std::string lines_geometry(const PolygonSet& set, const CoordinateLists& lists) {
  std::string same, mixed;
  bool has_points = false, has_segments = false;
  for (const Polygon& part : set.polygons) {
    const bool is_point = part.outer.size() == 1;
    (is_point ? has_points : has_segments) = true;
    const std::string place = is_point ? lists.of(part.outer[0]) : lists.of(part.outer, false);
    std::string one = geometry(is_point ? "Point" : "LineString", place);
    one.pop_back();  // the end of the line
    same += (same.empty() ? "" : ",") + place;
    mixed += (mixed.empty() ? "" : ",") + one;
  }
  if (has_points && has_segments) {
    return "{\"type\":\"GeometryCollection\",\"geometries\":[" + mixed + "]}\n";
  }
  return geometry(has_points ? "MultiPoint" : "MultiLineString", "[" + same + "]");
}

}  // namespace

std::string write_geojson(const PolygonSet& set) {
  const CoordinateLists lists({"[", ",", "]", "[", ",", "]"});
  if (is_lines(set)) return lines_geometry(set, lists);
  if (set.polygons.size() != 1) return geometry("MultiPolygon", lists.of(set));
  const Polygon& first = set.polygons[0];
  if (set.is_point()) return geometry("Point", lists.of(first.outer[0]));
  if (set.is_segment()) return geometry("LineString", lists.of(first.outer, false));
  return geometry("Polygon", lists.of(first));
}

}  // namespace minkref
