#include "formats/decimal.hpp"
#include "formats/write.hpp"
#include "reference/error.hpp"
#include "reference/plane/lines.hpp"

namespace minkref {
namespace {

void append(std::string& text, const Ring& ring, const char* role) {
  text += std::to_string(ring.size()) + " " + role + "\n";
  for (const Point& p : ring) text += decimal(p.x) + " " + decimal(p.y) + "\n";
  for (std::size_t i = 1; i <= ring.size(); ++i) {
    text += std::to_string(i) + (i < ring.size() ? " " : "\n");
  }
}

}  // namespace

std::string write_poly(const PolygonSet& set) {
  if (!set.empty() && !has_area(set)) {
    throw BadInput("not-representable", "the format .poly has no points and no segments",
                   "write the set as WKT, GeoJSON or JSON");
  }
  std::string text = std::to_string(set.rings()) + "\n";
  for (const Polygon& polygon : set.polygons) {
    append(text, polygon.outer, "out");
    for (const Ring& hole : polygon.holes) append(text, hole, "in");
  }
  return text;
}

}  // namespace minkref
