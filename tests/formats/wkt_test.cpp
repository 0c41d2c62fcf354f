#include "tests/formats/refusal.hpp"

namespace minkref::of_wkt {
namespace {

PolygonSet wkt(std::string_view text) { return read_valid_text(text, Format::wkt, "input").set; }
std::string code(std::string_view text) { return code_of(text, Format::wkt); }

TEST(Wkt, APolygonWithAHoleKeepsItsVerticesInOrder) {
  const PolygonSet set = wkt("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1))");
  const Ring outer = {point("0", "0"), point("9", "0"), point("9", "9"), point("0", "9")};
  const Ring hole = {point("1", "1"), point("1", "2"), point("2", "1")};
  EXPECT_EQ(set, (PolygonSet{{{outer, {hole}}}}));
}

TEST(Wkt, WordsMayBeInAnyCaseAndSpaceAnywhere) {
  const PolygonSet set =
      wkt("\r\n mUltiPolygon\t( ( (0 0,1 0 ,0 1, 0 0) ),\r\n((5 5,6 5,5 6,5 5)))\n");
  EXPECT_EQ(set.polygons.size(), 2U);
  EXPECT_EQ(set.vertices(), 6U);
}

TEST(Wkt, RingsAreTurnedAsTheirRoleDemands) {
  const PolygonSet set = wkt("POLYGON((0 0,0 9,9 9,9 0,0 0),(1 1,2 1,1 2,1 1))");
  EXPECT_GT(doubled_area(set.polygons[0].outer), 0);
  EXPECT_LT(doubled_area(set.polygons[0].holes[0]), 0);
}

TEST(Wkt, EveryEmptyGeometryIsTheEmptySet) {
  for (const char* text : {"POLYGON EMPTY", "polygon empty", "MULTIPOLYGON EMPTY", "POINT EMPTY",
                           "LINESTRING EMPTY", "GEOMETRYCOLLECTION EMPTY",
                           "MULTIPOLYGON (EMPTY, EMPTY)", "GEOMETRYCOLLECTION (POINT EMPTY)"}) {
    EXPECT_TRUE(wkt(text).empty()) << text;
  }
}

TEST(Wkt, APointAndASegmentAreOperands) {
  EXPECT_TRUE(wkt("POINT (1 2)").is_point());
  EXPECT_TRUE(wkt("LINESTRING (1 2, 3 4)").is_segment());
}

TEST(Wkt, ACollectionOfPolygonsIsOneSet) {
  const PolygonSet set =
      wkt("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), GEOMETRYCOLLECTION (MULTIPOLYGON "
          "(((5 5, 6 5, 5 6, 5 5)), ((8 8, 9 8, 8 9, 8 8)))))");
  EXPECT_EQ(set.polygons.size(), 3U);
}

TEST(Wkt, CoordinatesBeyondXAndYAreDroppedWithAWarning) {
  const PolygonSet plain = wkt("POLYGON ((0 0, 1 0, 0 1, 0 0))");
  for (const char* text :
       {"POLYGON Z ((0 0 1, 1 0 2, 0 1 -3.5, 0 0 7))", "POLYGONZ ((0 0 1, 1 0 1, 0 1 1, 0 0 1))",
        "polygon m ((0 0 1, 1 0 1, 0 1 1, 0 0 1))", "POLYGON((0 0 1, 1 0 1, 0 1 NaN, 0 0 1))",
        "SRID=25832;POLYGON ZM ((0 0 1 2, 1 0 1 2, 0 1 1 2, 0 0 1 2))"}) {
    const Reading reading = read_text(text, Format::wkt, "input");
    EXPECT_EQ(reading.set, plain) << text;
    ASSERT_FALSE(reading.warnings.empty()) << text;
    EXPECT_EQ(reading.warnings.back(),
              "input: line 1: dropped: " + std::string(text[0] == 'S' ? "8" : "4") +
                  " coordinates beyond x and y, from here on");
  }
  EXPECT_TRUE(read_text("POLYGON Z EMPTY", Format::wkt, "").warnings.empty());
}

TEST(Wkt, AReferenceSystemIsDroppedWithAWarning) {
  const Reading reading = read_text("SRID=4326;\nPOINT (1 2)", Format::wkt, "input");
  EXPECT_EQ(reading.set, wkt("POINT (1 2)"));
  EXPECT_EQ(reading.warnings,
            std::vector<std::string>{"input: line 1: dropped: the reference system (SRID): numbers "
                                     "are coordinates in the plane"});
  EXPECT_EQ(code("SRID=4326 POINT (1 2)"), "syntax");
}

TEST(Wkt, AMissingCommaIsNoThirdCoordinate) {
  expect_code(code, "three-dimensional",
              {"POLYGON ((0 0, 1 0 1 1, 0 1, 0 0))", "POLYGON ((0 0 1, 1 0, 0 1 1, 0 0 1))",
               "POINT Z (1 2)", "POINT ZM (1 2 3)", "POINT (1 2 3 4 5)"});
  const BadInput refused = refusal_of_text("POLYGON ((0 0,\n 1 0 1 1,\n 0 1, 0 0))", Format::wkt);
  EXPECT_EQ(refused.place().line, 2U);
  EXPECT_EQ(refused.place().ring, 0U);
  EXPECT_EQ(refused.place().vertices, std::vector<std::size_t>{1});
  EXPECT_EQ(code("POINT Z (1 2 high)"), "not-a-number");
}

TEST(Wkt, OtherGeometriesAreRefused) {
  EXPECT_EQ(code("LINESTRING (0 0)"), "not-a-segment");
  EXPECT_EQ(code("LINESTRING (0 0, 1 0, 1 0)"), "zero-length-edge");
  EXPECT_EQ(code("LINESTRING (0 0, 1 0, 1 1)"), "open-lines");
  expect_code(code, "unsupported-geometry", {"MULTICURVE ((0 0))", "CURVEPOLYGON EMPTY"});
}

TEST(Wkt, LinesAreSegmentsAndPoints) {
  const auto parts = [](std::string_view text) {
    return read_text(text, Format::wkt, "").set.polygons.size();
  };
  EXPECT_EQ(parts("LINESTRING (0 0, 1 0, 1 1, 0 0)"), 3U);
  EXPECT_EQ(parts("MULTIPOINT ((0 0), EMPTY, 1 1, (2 2))"), 3U);
  EXPECT_EQ(parts("MULTILINESTRING ((0 0, 1 0), EMPTY, (0 1, 1 1, 2 1))"), 3U);
  EXPECT_EQ(parts("GEOMETRYCOLLECTION (POINT (0 0), LINESTRING (1 1, 2 2, 3 1))"), 3U);
  EXPECT_TRUE(wkt("MULTIPOINT ((1 2))").is_point());
}

TEST(Wkt, APointBesideOtherPartsIsRefused) {
  EXPECT_EQ(code("GEOMETRYCOLLECTION (POINT (0 0), POLYGON ((0 0, 1 0, 0 1, 0 0)))"),
            "mixed-operand");
  EXPECT_EQ(code("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), LINESTRING (1 1, 2 2))"),
            "mixed-operand");
}

TEST(Wkt, AnOpenRingIsRefusedWithBothEnds) {
  const BadInput refused = refusal_of_text("POLYGON ((0 0,\n 1 0,\n 1 1,\n 0 1/2))", Format::wkt);
  EXPECT_EQ(refused.code(), "ring-not-closed");
  EXPECT_EQ(refused.place().line, 4U);
  EXPECT_EQ(refused.place().vertices, (std::vector<std::size_t>{0, 3}));
  EXPECT_EQ(refused.place().coordinates, (std::vector<std::string>{"(0, 0)", "(0, 0.5)"}));
}

TEST(Wkt, ARingOfFewerThanThreeVerticesIsNoSegmentInDisguise) {
  expect_code(code, "too-few-vertices",
              {"POLYGON ((0 0, 1 1, 0 0))", "POLYGON ((0 0))",
               "POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 2, 1 1))"});
}

TEST(Wkt, TextAfterTheGeometryIsRefused) {
  EXPECT_EQ(code("POINT (1 2) POINT (3 4)"), "trailing-text");
  EXPECT_EQ(code("POINT (1 2));"), "trailing-text");
}

TEST(Wkt, ABadNumberIsRefusedWithRingVertexAndLine) {
  const BadInput refused =
      refusal_of_text("POLYGON ((0 0, 9 0, 0 9, 0 0),\n(1 1, 2 1,\n1 two, 1 1))", Format::wkt);
  EXPECT_EQ(refused.code(), "not-a-number");
  EXPECT_EQ(refused.place().line, 3U);
  EXPECT_EQ(refused.place().ring, 1U);
  EXPECT_EQ(refused.place().vertices, (std::vector<std::size_t>{2}));
}

TEST(Wkt, WrongGrammarIsRefused) {
  expect_code(code, "syntax",
              {"POLYGON (0 0, 1 0, 1 1, 0 0)", "POLYGON 0", "42", "POINT (1, 2)",
               "POLYGON ((0 0, 1 0,, 1 1, 0 0))", "(POINT (1 2))", "POINT ((1 2))"});
}

}  // namespace
}  // namespace minkref::of_wkt
