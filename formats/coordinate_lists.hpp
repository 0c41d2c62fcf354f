#pragma once

#include <string>
#include <string_view>

#include "reference/plane/polygon_set.hpp"

namespace minkref {

/// Nested lists of decimal coordinates for WKT and GeoJSON.
class CoordinateLists {
 public:
  struct Marks {
    std::string_view open_point, between_numbers, close_point, open_list, between, close_list;
  };

  explicit CoordinateLists(const Marks& marks) : marks_(marks) {}

  std::string of(const Point& point) const;
  /// Repeats the first vertex of a closed ring.
  std::string of(const Ring& ring, bool closed) const;
  std::string of(const Polygon& polygon) const;
  std::string of(const PolygonSet& set) const;

 private:
  Marks marks_;
};

}  // namespace minkref
