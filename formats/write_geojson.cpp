#include "formats/decimal.hpp"
#include "formats/write.hpp"

namespace minkref {
namespace {

void append(std::string& text, const Point& point) {
  text += "[" + decimal(point.x) + "," + decimal(point.y) + "]";
}

/// The first vertex is repeated where the ring is closed.
void append(std::string& text, const Ring& ring, bool closed) {
  text += "[";
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0) text += ",";
    append(text, ring[i]);
  }
  if (closed) {
    text += ",";
    append(text, ring.front());
  }
  text += "]";
}

void append(std::string& text, const Polygon& polygon) {
  text += "[";
  append(text, polygon.outer, true);
  for (const Ring& hole : polygon.holes) {
    text += ",";
    append(text, hole, true);
  }
  text += "]";
}

std::string geometry(const std::string& type, const std::string& coordinates) {
  return "{\"type\":\"" + type + "\",\"coordinates\":" + coordinates + "}\n";
}

}  // namespace

std::string write_geojson(const PolygonSet& set) {
  std::string text;
  if (set.is_point()) {
    append(text, set.polygons[0].outer[0]);
    return geometry("Point", text);
  }
  if (set.is_segment()) {
    append(text, set.polygons[0].outer, false);
    return geometry("LineString", text);
  }
  if (set.polygons.size() == 1) {
    append(text, set.polygons[0]);
    return geometry("Polygon", text);
  }
  text += "[";
  for (std::size_t i = 0; i < set.polygons.size(); ++i) {
    if (i > 0) text += ",";
    append(text, set.polygons[i]);
  }
  return geometry("MultiPolygon", text + "]");
}

}  // namespace minkref
