#include "formats/coordinate_lists.hpp"
#include "formats/write.hpp"
#include "reference/plane/lines.hpp"

namespace minkref {
namespace {

/// One type of geometry if all parts are points, or all segments; else a collection.
std::string lines_text(const PolygonSet& set, const CoordinateLists& lists) {
  const auto of_part = [&](const Polygon& part) { return lists.of(part.outer, false); };
  std::string same, mixed;
  bool has_points = false, has_segments = false;
  for (const Polygon& part : set.polygons) {
    const bool is_point = part.outer.size() == 1;
    (is_point ? has_points : has_segments) = true;
    same += (same.empty() ? "" : ", ") + of_part(part);
    mixed += (mixed.empty() ? "" : ", ") + std::string(is_point ? "POINT " : "LINESTRING ") +
             of_part(part);
  }
  if (has_points && has_segments) return "GEOMETRYCOLLECTION (" + mixed + ")";
  return (has_points ? "MULTIPOINT (" : "MULTILINESTRING (") + same + ")";
}

}  // namespace

std::string write_wkt(const PolygonSet& set) {
  if (set.empty()) return "POLYGON EMPTY\n";
  const CoordinateLists lists({"", " ", "", "(", ", ", ")"});
  const Polygon& first = set.polygons[0];
  std::string text;
  if (set.is_point()) {
    text = "POINT " + lists.of(first.outer, false);
  } else if (set.is_segment()) {
    text = "LINESTRING " + lists.of(first.outer, false);
  } else if (is_lines(set)) {
    text = lines_text(set, lists);
  } else if (set.polygons.size() == 1) {
    text = "POLYGON " + lists.of(first);
  } else {
    text = "MULTIPOLYGON " + lists.of(set);
  }
  return text + "\n";
}

}  // namespace minkref
