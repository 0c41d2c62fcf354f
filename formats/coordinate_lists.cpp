#include "formats/coordinate_lists.hpp"

#include "formats/decimal.hpp"

namespace minkref {

std::string CoordinateLists::of(const Point& point) const {
  std::string text(marks_.open_point);
  text += decimal(point.x);
  text += marks_.between_numbers;
  text += decimal(point.y);
  text += marks_.close_point;
  return text;
}

std::string CoordinateLists::of(const Ring& ring, bool closed) const {
  std::string text(marks_.open_list);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0) text += marks_.between;
    text += of(ring[i]);
  }
  if (closed) {
    text += marks_.between;
    text += of(ring.front());
  }
  text += marks_.close_list;
  return text;
}

std::string CoordinateLists::of(const Polygon& polygon) const {
  std::string text(marks_.open_list);
  text += of(polygon.outer, true);
  for (const Ring& hole : polygon.holes) {
    text += marks_.between;
    text += of(hole, true);
  }
  text += marks_.close_list;
  return text;
}

std::string CoordinateLists::of(const PolygonSet& set) const {
  std::string text(marks_.open_list);
  for (std::size_t i = 0; i < set.polygons.size(); ++i) {
    if (i > 0) text += marks_.between;
    text += of(set.polygons[i]);
  }
  text += marks_.close_list;
  return text;
}

}  // namespace minkref
