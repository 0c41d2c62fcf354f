#include "formats/write.hpp"

#include <algorithm>
#include <fstream>

#include "formats/decimal.hpp"
#include "formats/svg.hpp"
#include "reference/error.hpp"
#include "reference/plane/lines.hpp"

namespace minkref {
namespace {

bool is_decimal(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(), [](const Point& p) {
    return has_exact_decimal(p.x) && has_exact_decimal(p.y);
  });
}

}  // namespace

std::string write(const PolygonSet& set, Format format) {
  switch (format) {
    case Format::wkt:
      return write_wkt(set);
    case Format::geojson:
      return write_geojson(set);
    case Format::poly:
      return write_poly(set);
    case Format::json:
      return write_json(set);
    case Format::svg:
      return write_svg({Layer{.name = "set", .region = set}});
    case Format::case_json:
      break;
  }
  throw BadInput("unknown-format", "a set alone is not a case",
                 "write it as json, wkt, geojson, poly or svg");
}

bool writes_exactly(const PolygonSet& set, Format format) {
  if (format == Format::json) return true;
  if (format == Format::svg || format == Format::case_json) return false;
  if (format == Format::poly && !set.empty() && !has_area(set)) return false;
  return std::all_of(set.polygons.begin(), set.polygons.end(), [](const Polygon& polygon) {
    return is_decimal(polygon.outer) &&
           std::all_of(polygon.holes.begin(), polygon.holes.end(), is_decimal);
  });
}

void write_file(const std::string& text, const std::string& path) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) {
    Place place;
    place.source = path;
    throw BadInput("cannot-write", "the file cannot be written",
                   "name a file in a folder that you may write to", place);
  }
}

}  // namespace minkref
