#include "tests/formats/refusal.hpp"

namespace minkref::of_plain_json {
namespace {

std::string code(std::string_view text) { return code_of(text, Format::json); }

const std::string triangle = R"([["0","0"],["1","0"],["0","1"]])";

TEST(PlainJson, NumbersMayBeStringsOrJsonNumbers) {
  const PolygonSet set =
      read_valid_text(R"({"polygons":[{"outer":[[0,"-1/2"],[1.5,0],["1e1",1E1]],"holes":[]}]})",
                      Format::json, "input")
          .set;
  const Ring ring = {point("0", "-1/2"), point("3/2", "0"), point("10", "10")};
  EXPECT_EQ(set, (PolygonSet{{{ring, {}}}}));
}

TEST(PlainJson, PointSegmentAndEmptySetAreOperands) {
  const auto set = [](std::string_view text) {
    return read_valid_text(text, Format::json, "input").set;
  };
  EXPECT_TRUE(set(R"({"polygons":[]})").empty());
  EXPECT_TRUE(set(R"({"polygons":[{"outer":[[1,2]]}]})").is_point());
  EXPECT_TRUE(set(R"({"polygons":[{"outer":[[1,2],[3,4]]}]})").is_segment());
}

TEST(PlainJson, AMisspeltMemberDoesNotLoseAHole) {
  EXPECT_EQ(code(R"({"polygons":[{"outer":)" + triangle + R"(,"hole":[]}]})"), "unknown-member");
  EXPECT_EQ(code(R"({"polygons":[],"polygon":[]})"), "unknown-member");
}

TEST(PlainJson, WrongStructureIsRefused) {
  EXPECT_EQ(code(R"({})"), "missing-member");
  expect_code(code, "wrong-type", {R"([])", R"({"polygons":{}})", R"({"polygons":[[]]})"});
  EXPECT_EQ(code(R"({"polygons":[{"holes":[]}]})"), "missing-member");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[]}]})"), "too-few-vertices");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[[1,2]],"holes":[)" + triangle + "]}]}"),
            "too-few-vertices");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[[1,2]]},{"outer":)" + triangle + "}]}"),
            "mixed-operand");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[[1,2],[3]]}]})"), "wrong-type");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[[1,2,3]]}]})"), "three-dimensional");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[[1,null]]}]})"), "not-a-number");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[[1,"1/0"]]}]})"), "zero-denominator");
  EXPECT_EQ(code(R"({"polygons":[{"outer":[[1," 1"]]}]})"), "not-a-number");
}

TEST(PlainJson, GeoJsonAndCasesAreToldApartByTheirMembers) {
  EXPECT_TRUE(
      read_text(R"({"coordinates":[1,2],"type":"Point"})", Format::json, "").set.is_point());
  const Reading reading = read_text(R"({"schema":"case-v1","id":"a","dimension":2,"scales":["1"],)"
                                    R"("P":{"polygons":[{"outer":[[1,2]]}]},"Q":{"polygons":[]}})",
                                    Format::json, "a.json");
  EXPECT_TRUE(reading.set.is_point());
  ASSERT_EQ(reading.warnings.size(), 1U);
  EXPECT_EQ(reading.warnings[0],
            "a.json: a case holds two operands and P is used; add #P or #Q to its name");
}

}  // namespace
}  // namespace minkref::of_plain_json
