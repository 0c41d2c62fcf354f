#include "formats/decimal.hpp"
#include "formats/write.hpp"

namespace minkref {
namespace {

void append(std::string& text, const Point& point) {
  text += decimal(point.x) + " " + decimal(point.y);
}

/// The first vertex is repeated where the ring is closed.
void append(std::string& text, const Ring& ring, bool closed) {
  text += "(";
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0) text += ", ";
    append(text, ring[i]);
  }
  if (closed) {
    text += ", ";
    append(text, ring.front());
  }
  text += ")";
}

void append(std::string& text, const Polygon& polygon) {
  text += "(";
  append(text, polygon.outer, true);
  for (const Ring& hole : polygon.holes) {
    text += ", ";
    append(text, hole, true);
  }
  text += ")";
}

}  // namespace

std::string write_wkt(const PolygonSet& set) {
  if (set.empty()) return "POLYGON EMPTY\n";
  std::string text;
  if (set.is_point()) {
    text = "POINT ";
    append(text, set.polygons[0].outer, false);
  } else if (set.is_segment()) {
    text = "LINESTRING ";
    append(text, set.polygons[0].outer, false);
  } else if (set.polygons.size() == 1) {
    text = "POLYGON ";
    append(text, set.polygons[0]);
  } else {
    text = "MULTIPOLYGON (";
    for (std::size_t i = 0; i < set.polygons.size(); ++i) {
      if (i > 0) text += ", ";
      append(text, set.polygons[i]);
    }
    text += ")";
  }
  return text + "\n";
}

}  // namespace minkref
