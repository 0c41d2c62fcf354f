#include "formats/read_geojson.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "formats/json_object.hpp"
#include "formats/message_text.hpp"

namespace minkref {
namespace {

constexpr std::array<std::string_view, 9> geojson_types{
    "Polygon",         "MultiPolygon",       "Point",   "LineString",       "MultiPoint",
    "MultiLineString", "GeometryCollection", "Feature", "FeatureCollection"};

class GeoJsonReader {
 public:
  explicit GeoJsonReader(SetBuilder& set) : set_(set), input_(set.input()) {}

  // The JSON text's limited depth bounds the recursion.
  void object(Json value) {
    const JsonObject members(value, input_, "a GeoJSON object",
                             {"type", "coordinates", "geometry", "geometries", "features", "crs"},
                             JsonObject::Others::ignored);
    const Json type_member = members.require("type");
    expect(type_member, JsonKind::string, "the type of a GeoJSON object", input_);
    const std::string type = type_member.string();
    if (const auto crs = members.find("crs"); crs && !crs->is(JsonKind::null)) {
      set_.drop("the reference system (crs): numbers are coordinates in the plane", crs->line());
    }
    if (type == "FeatureCollection") {
      each(members.require("features"), "features", [&](Json feature) { object(feature); });
    } else if (type == "Feature") {
      const Json geometry = members.require("geometry");
      if (!geometry.is(JsonKind::null)) object(geometry);
    } else if (type == "GeometryCollection") {
      each(members.require("geometries"), "geometries", [&](Json geometry) { object(geometry); });
    } else if (type == "Polygon") {
      polygon(members.require("coordinates"));
    } else if (type == "MultiPolygon") {
      each(members.require("coordinates"), "the coordinates of a MultiPolygon",
           [&](Json rings) { polygon(rings); });
    } else if (type == "Point") {
      point(members.require("coordinates"));
    } else if (type == "LineString") {
      line(members.require("coordinates"));
    } else if (type == "MultiPoint") {
      each(members.require("coordinates"), "the coordinates of a MultiPoint",
           [&](Json position) { point(position); });
    } else if (type == "MultiLineString") {
      each(members.require("coordinates"), "the coordinates of a MultiLineString",
           [&](Json positions) { line(positions); });
    } else {
      input_.refuse("unsupported-geometry", in_quotes(type) + " is not an operand in the plane",
                    "give a Polygon, a Point or a LineString, or several: MultiPolygon",
                    type_member.line());
    }
  }

 private:
  template <class Item>
  void each(Json list, const std::string& what, Item item) {
    expect(list, JsonKind::array, what, input_);
    for (const Json element : list) item(element);
  }

  void position(Json value, TextRing& ring) {
    Place where = ring.place_of(ring.points.size());
    where.line = value.line();
    if (!value.is(JsonKind::array) || value.size() < 2) {
      input_.refuse("wrong-type", "a position must be an array of two numbers", "write [x, y]",
                    where);
    }
    if (value.size() > 4) {
      input_.refuse("three-dimensional", "a position has more than four coordinates",
                    "drop all but x and y", where);
    }
    const Json x = *value.begin();
    const Json y = *++value.begin();
    if (!x.is(JsonKind::number) || !y.is(JsonKind::number)) {
      input_.refuse("not-a-number", "a coordinate of a position is not a JSON number",
                    "write [x, y] with two finite numbers", where);
    }
    std::size_t at = 0;
    for (const Json more : value) {
      if (at++ < 2) continue;
      if (!more.is(JsonKind::number) && !more.is(JsonKind::null)) {
        input_.refuse("not-a-number", "the altitude of a position is not a JSON number",
                      "write [x, y], or [x, y, altitude]", where);
      }
      set_.drop_coordinate(more.is(JsonKind::null) ? "0" : more.text(), where);
    }
    set_.vertex(ring, x.text(), y.text(), value.line());
  }

  TextRing ring(Json positions, const std::string& what) {
    TextRing fresh = set_.ring(positions.line());
    each(positions, what, [&](Json value) { position(value, fresh); });
    return fresh;
  }

  void polygon(Json rings) {
    std::vector<TextRing> read;
    each(rings, "the coordinates of a polygon", [&](Json positions) {
      read.push_back(ring(positions, "a ring"));
      set_.close(read.back());
    });
    if (read.empty()) return;  // empty coordinates: the empty set
    TextRing outer = std::move(read.front());
    read.erase(read.begin());
    set_.polygon(std::move(outer), std::move(read));
  }

  void point(Json coordinates) {
    expect(coordinates, JsonKind::array, "the coordinates of a point", input_);
    if (coordinates.size() == 0) return;
    TextRing fresh = set_.ring(coordinates.line());
    position(coordinates, fresh);
    set_.point(std::move(fresh));
  }

  void line(Json coordinates) {
    const TextRing vertices = ring(coordinates, "the coordinates of a LineString");
    if (!vertices.points.empty()) set_.line(vertices, "LineString", "positions");
  }

  SetBuilder& set_;
  Input& input_;
};

}  // namespace

void read_geojson(Json root, SetBuilder& set) { GeoJsonReader(set).object(root); }

bool looks_like_geojson(Json root) {
  bool found = false;
  if (!root.is(JsonKind::object)) return false;
  root.for_each_member([&](const std::string& name, Json value) {
    if (name == "type" && value.is(JsonKind::string)) {
      found = found || std::find(geojson_types.begin(), geojson_types.end(), value.string()) !=
                           geojson_types.end();
    }
  });
  return found;
}

}  // namespace minkref
