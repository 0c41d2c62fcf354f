#include "formats/coordinate_lists.hpp"
#include "formats/write.hpp"

namespace minkref {
namespace {

std::string geometry(const std::string& type, const std::string& coordinates) {
  return "{\"type\":\"" + type + "\",\"coordinates\":" + coordinates + "}\n";
}

}  // namespace

std::string write_geojson(const PolygonSet& set) {
  const CoordinateLists lists({"[", ",", "]", "[", ",", "]"});
  if (set.polygons.size() != 1) return geometry("MultiPolygon", lists.of(set));
  const Polygon& first = set.polygons[0];
  if (set.is_point()) return geometry("Point", lists.of(first.outer[0]));
  if (set.is_segment()) return geometry("LineString", lists.of(first.outer, false));
  return geometry("Polygon", lists.of(first));
}

}  // namespace minkref
