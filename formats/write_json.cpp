#include "formats/write.hpp"

namespace minkref {
namespace {

void append(std::string& text, const Ring& ring) {
  text += "[";
  for (std::size_t i = 0; i < ring.size(); ++i) {
    text += i > 0 ? ",[\"" : "[\"";
    text += to_string(ring[i].x) + "\",\"" + to_string(ring[i].y) + "\"]";
  }
  text += "]";
}

}  // namespace

std::string write_json(const PolygonSet& set) {
  std::string text = "{\"polygons\":[";
  for (std::size_t i = 0; i < set.polygons.size(); ++i) {
    const Polygon& polygon = set.polygons[i];
    text += i > 0 ? ",{\"holes\":[" : "{\"holes\":[";
    for (std::size_t j = 0; j < polygon.holes.size(); ++j) {
      if (j > 0) text += ",";
      append(text, polygon.holes[j]);
    }
    text += "],\"outer\":";
    append(text, polygon.outer);
    text += "}";
  }
  return text + "]}\n";
}

}  // namespace minkref
