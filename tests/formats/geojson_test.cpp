#include "tests/formats/refusal.hpp"

namespace minkref::of_geojson {
namespace {

PolygonSet geojson(std::string_view text) {
  return read_valid_text(text, Format::geojson, "input").set;
}
std::string code(std::string_view text) { return code_of(text, Format::geojson); }

const std::string triangle = "[[[0,0],[1,0],[0,1],[0,0]]]";
const std::string far_triangle = "[[[5,5],[6,5],[5,6],[5,5]]]";

std::string feature(const std::string& type, const std::string& coordinates) {
  return R"({"type":"Feature","properties":{"a":[1e999999999]},"geometry":{"coordinates":)" +
         coordinates + R"(,"type":")" + type + "\"}}";
}

TEST(GeoJson, APolygonMayStandAsGeometryFeatureOrCollection) {
  const PolygonSet expected = {{{{point("0", "0"), point("1", "0"), point("0", "1")}, {}}}};
  EXPECT_EQ(geojson(R"({"type":"Polygon","coordinates":)" + triangle + "}"), expected);
  EXPECT_EQ(geojson(feature("Polygon", triangle)), expected);
  EXPECT_EQ(geojson(R"({"features":[)" + feature("Polygon", triangle) +
                    R"(],"type":"FeatureCollection"})"),
            expected);
  EXPECT_EQ(
      geojson(R"({"type":"GeometryCollection","geometries":[{"type":"Polygon","coordinates":)" +
              triangle + "}]}"),
      expected);
}

TEST(GeoJson, SeveralPolygonalFeaturesAreOneSet) {
  const PolygonSet set =
      geojson(R"({"type":"FeatureCollection","features":[)" + feature("Polygon", triangle) + "," +
              feature("MultiPolygon", "[" + far_triangle + "]") +
              R"(,{"type":"Feature","geometry":null,"properties":null}]})");
  EXPECT_EQ(set.polygons.size(), 2U);
}

TEST(GeoJson, PointSegmentAndEmptySetAreOperands) {
  EXPECT_TRUE(geojson(R"({"type":"Point","coordinates":[1,2]})").is_point());
  EXPECT_TRUE(geojson(R"({"type":"LineString","coordinates":[[1,2],[3,4]]})").is_segment());
  EXPECT_TRUE(geojson(R"({"type":"Polygon","coordinates":[]})").empty());
  EXPECT_TRUE(geojson(R"({"type":"FeatureCollection","features":[]})").empty());
}

TEST(GeoJson, RingsAreTurnedAsTheirRoleDemands) {
  const PolygonSet set = geojson(
      R"({"type":"Polygon","coordinates":[[[0,0],[0,9],[9,0],[0,0]],[[1,1],[2,1],[1,2],[1,1]]]})");
  EXPECT_GT(doubled_area(set.polygons[0].outer), 0);
  EXPECT_LT(doubled_area(set.polygons[0].holes[0]), 0);
}

TEST(GeoJson, MembersMayBeEscapedButNotRepeated) {
  EXPECT_TRUE(geojson("{\"t\\u0079pe\":\"Po\\u0069nt\",\"coordinates\":[1,2]}").is_point());
  EXPECT_EQ(code(R"({"type":"Point","type":"Point","coordinates":[1,2]})"), "duplicate-member");
}

TEST(GeoJson, WhatIsNoOperandIsRefused) {
  EXPECT_EQ(code(R"({"type":"Sphere"})"), "unsupported-geometry");
  EXPECT_EQ(code(R"({"type":"LineString","coordinates":[[1,2]]})"), "not-a-segment");
  EXPECT_EQ(code(R"({"type":"LineString","coordinates":[[1,2],[3,4],[5,7]]})"), "open-lines");
  EXPECT_EQ(code(R"({"type":"MultiPoint","coordinates":[[1,2],[3,4]]})"), "open-lines");
  EXPECT_EQ(code(R"({"type":"MultiLineString","coordinates":[[[1,2],[3,4]],[[5,6],[7,8]]]})"),
            "open-lines");
  EXPECT_EQ(code(R"({"type":"Point","coordinates":[1,2,3,4,5]})"), "three-dimensional");
  EXPECT_EQ(code(R"({"coordinates":[1,2]})"), "missing-member");
  EXPECT_EQ(code(R"({"type":"Polygon"})"), "missing-member");
  expect_code(code, "wrong-type",
              {R"({"type":7})", R"([1,2])", R"({"type":"Polygon","coordinates":{"0":1}})",
               R"({"type":"Point","coordinates":[1]})"});
  EXPECT_EQ(code(R"({"type":"Point","coordinates":["1","2"]})"), "not-a-number");
  EXPECT_EQ(code(R"({"type":"Point","coordinates":[null,2]})"), "not-a-number");
}

TEST(GeoJson, AltitudesAndReferenceSystemsAreDroppedWithAWarning) {
  const Reading reading = read_text(
      "{\"type\":\"Polygon\",\"crs\":{\"type\":\"name\"},\n"
      "\"coordinates\":[[[0,0],[1,0,1e3],[0,1,-7.25,null],[0,0]]]}",
      Format::geojson, "input");
  EXPECT_EQ(reading.set,
            geojson(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]})"));
  EXPECT_EQ(reading.warnings,
            (std::vector<std::string>{"input: line 1: dropped: the reference system (crs): numbers "
                                      "are coordinates in the plane",
                                      "input: line 2: dropped: 3 coordinates beyond x and y, from "
                                      "here on"}));
  EXPECT_TRUE(read_text(R"({"type":"Point","coordinates":[1,2],"crs":null})", Format::geojson, "")
                  .warnings.empty());
  EXPECT_EQ(code(R"({"type":"Point","coordinates":[1,2,"3"]})"), "not-a-number");
}

TEST(GeoJson, AnOpenRingIsRefusedWithItsLine) {
  const BadInput refused = refusal_of_text(
      "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],\n[1,0],\n[0,1]]]}", Format::geojson);
  EXPECT_EQ(refused.code(), "ring-not-closed");
  EXPECT_EQ(refused.place().line, 3U);
  EXPECT_EQ(refused.place().vertices, (std::vector<std::size_t>{0, 2}));
}

}  // namespace
}  // namespace minkref::of_geojson
