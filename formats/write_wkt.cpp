#include "formats/coordinate_lists.hpp"
#include "formats/write.hpp"

namespace minkref {

std::string write_wkt(const PolygonSet& set) {
  if (set.empty()) return "POLYGON EMPTY\n";
  const CoordinateLists lists({"", " ", "", "(", ", ", ")"});
  const Polygon& first = set.polygons[0];
  std::string text;
  if (set.is_point()) {
    text = "POINT " + lists.of(first.outer, false);
  } else if (set.is_segment()) {
    text = "LINESTRING " + lists.of(first.outer, false);
  } else if (set.polygons.size() == 1) {
    text = "POLYGON " + lists.of(first);
  } else {
    text = "MULTIPOLYGON " + lists.of(set);
  }
  return text + "\n";
}

}  // namespace minkref
