#include "formats/case.hpp"

#include <filesystem>
#include <fstream>

#include "formats/write.hpp"
#include "tests/formats/refusal.hpp"
#include "tests/formats/temporary_folder.hpp"

namespace minkref::of_case {
namespace {

const std::string square = R"({"polygons":[{"outer":[[0,0],["9",0],["9","9"],["0","9"]],)"
                           R"("holes":[[["1","1"],["1","2"],["2","1"]]]}]})";
const std::string triangle =
    R"({"polygons":[{"outer":[["0","0"],["1/3","0"],["0","-30.7428e-2"]]}]})";
const std::string good_triangle = R"({"polygons":[{"outer":[["0","0"],["1/3","0"],["0","1"]]}]})";

std::string case_text(const std::string& members, const std::string& Q = good_triangle) {
  return R"({"schema":"case-v1","id":"a","dimension":2,"P":)" + square + ",\n\"Q\":" + Q + "," +
         members + "}";
}

std::string code(const std::string& text) {
  return refusal_of([&] { read_case_text(text, "input"); }).code();
}

TEST(CaseFile, EveryFieldIsRead) {
  const std::string digest(64, 'a');
  const Case value =
      read_case_text(
          case_text(
              R"("title":"t","comment":"c","scales":["1/3",2,"1.5"],"tags":["hole"],)"
              R"("flags":["slow"],"source":"s","licence":"Apache-2.0","certificate":"a.cert",)"
              R"("expected":[{"scale":"1/3","digest":")" +
              digest + R"(","components":1,"holes":0,"vertices":7,"area":"1/9","result":)" +
              good_triangle + "}]"),
          "input")
          .value;
  EXPECT_EQ(value.id, "a");
  EXPECT_EQ(value.title, "t");
  EXPECT_EQ(value.comment, "c");
  EXPECT_EQ(value.P.vertices(), 7U);
  EXPECT_EQ(value.Q.polygons[0].outer[1].x, Rational(1, 3));
  EXPECT_EQ(value.scales, (std::vector<Rational>{Rational(1, 3), 2, Rational(3, 2)}));
  EXPECT_EQ(value.tags, (std::vector<std::string>{"hole"}));
  EXPECT_EQ(value.flags, (std::vector<std::string>{"slow"}));
  EXPECT_EQ(value.source, "s");
  EXPECT_EQ(value.licence, "Apache-2.0");
  EXPECT_EQ(value.certificate, "a.cert");
  ASSERT_EQ(value.expected.size(), 1U);
  EXPECT_EQ(value.expected[0].digest, digest);
  EXPECT_EQ(value.expected[0].components, 1U);
  EXPECT_EQ(value.expected[0].holes, 0U);
  EXPECT_EQ(value.expected[0].vertices, 7U);
  EXPECT_EQ(value.expected[0].area, Rational(1, 9));
  EXPECT_EQ(value.expected[0].result, value.Q);
}

TEST(CaseFile, WrittenAndReadAgainIsTheSame) {
  const std::string digest(64, '0');
  for (const std::string& members : std::vector<std::string>{
           R"("scales":["1/3","7"])",
           R"("interval":{"from":"1/10","to":"10"},"title":"say \"hi\"\n","tags":["a","b"])",
           R"("interval":{},"expected":[{"scale":"1","holes":2,"digest":")" + digest +
               R"("},{"scale":"2","result":)" + square + "}]"}) {
    const Case once = read_case_text(case_text(members), "input").value;
    EXPECT_EQ(read_case_text(write_case(once), "input").value, once) << write_case(once);
  }
}

TEST(CaseFile, AScaleMayHaveAFactorForEachAxis) {
  const Case value =
      read_case_text(
          case_text(R"("scales":["3",["2","1/3"]],"expected":[{"scale":["2","1/3"],"holes":1}])"),
          "input")
          .value;
  const PlaneScaling factors{2, Rational(1, 3)};
  EXPECT_EQ(value.scales, (std::vector<Rational>{3}));
  EXPECT_EQ(value.axes, (std::vector<PlaneScaling>{factors}));
  EXPECT_EQ(value.expected[0].axes, factors);
  EXPECT_EQ(read_case_text(write_case(value), "input").value, value) << write_case(value);
}

TEST(CaseFile, OtherListsThanOfTwoPositiveFactorsAreRefused) {
  EXPECT_EQ(code(case_text(R"("scales":[["1","2","3"]])")), "wrong-type");
  EXPECT_EQ(code(case_text(R"("scales":[["1"]])")), "wrong-type");
  EXPECT_EQ(code(case_text(R"("scales":[["1","0"]])")), "scale-not-positive");
}

TEST(CaseFile, WrongOrientationIsRefusedAndNotTurned) {
  const Reading reading =
      read_text(case_text(R"("scales":["1"])", triangle), Format::case_json, "input#Q");
  EXPECT_LT(doubled_area(reading.set.polygons[0].outer), 0);
  const BadInput refused = refusal_of([&] {
    read_valid_text(case_text(R"("scales":["1"])", triangle), Format::case_json, "input#Q");
  });
  EXPECT_EQ(refused.code(), "wrong-orientation");
  EXPECT_EQ(refused.place().source, "input#Q");
  EXPECT_EQ(refused.place().line, 2U);
}

TEST(CaseFile, ReadingTheFileValidatesBothOperands) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.json", case_text(R"("scales":["1"])"));
  EXPECT_EQ(read_case(path).P.vertices(), 7U);
  EXPECT_EQ(read_valid_file(path + "#Q").set.vertices(), 3U);
  EXPECT_TRUE(read_valid_file(path + "#Q").warnings.empty());
  const std::string wrong = folder.file("b.json", case_text(R"("scales":["1"])", triangle));
  const BadInput refused = refusal_of([&] { read_case(wrong); });
  EXPECT_EQ(refused.code(), "wrong-orientation");
  EXPECT_EQ(refused.place().source, wrong + "#Q");
}

TEST(CaseFile, OnlyACaseHasOperandsToName) {
  EXPECT_EQ(refusal_of([] { read_text("POINT (1 2)", Format::wkt, "a.wkt#P"); }).code(),
            "not-a-case");
  EXPECT_EQ(refusal_of([] { read_text(good_triangle, Format::json, "a.json#P"); }).code(),
            "not-a-case");
}

TEST(CaseFile, JsonNumbersOfACaseAreIntegers) {
  EXPECT_EQ(code(case_text(R"("scales":[0.5])")), "not-a-number");
  EXPECT_EQ(
      code(case_text(R"("scales":["1"])", R"({"polygons":[{"outer":[[0,0],[1.5,0],[0,1]]}]})")),
      "not-a-number");
}

TEST(CaseFile, ScalesThatAreNotPositiveAreRefused) {
  expect_code(code, "scale-not-positive",
              {case_text(R"("scales":["0"])"), case_text(R"("scales":["1","-1/2"])"),
               case_text(R"("interval":{"from":"0"})")});
  EXPECT_EQ(code(case_text(R"("interval":{"from":"2","to":"1"})")), "empty-interval");
}

TEST(CaseFile, WhatTheSchemaForbidsIsRefused) {
  EXPECT_EQ(code(case_text(R"("tags":[])")), "missing-member");
  EXPECT_EQ(code(case_text(R"("scales":["1"],"interval":{})")), "duplicate-member");
  EXPECT_EQ(code(case_text(R"("scales":[])")), "missing-member");
  EXPECT_EQ(code(case_text(R"("scales":["1"],"scale":"1")")), "unknown-member");
  EXPECT_EQ(code(case_text(R"("scales":["1"],"tags":"hole")")), "wrong-type");
  EXPECT_EQ(code(case_text(R"("scales":["1"],"tags":[1])")), "wrong-type");
  EXPECT_EQ(code(case_text(R"("scales":["1"],"expected":[{"holes":1}])")), "missing-member");
  expect_code(code, "wrong-type",
              {case_text(R"("scales":["1"],"expected":[{"scale":"1","holes":-1}])"),
               case_text(R"("scales":["1"],"expected":[{"scale":"1","holes":"1"}])"),
               case_text(R"("scales":["1"],"expected":[{"scale":"1","digest":"abc"}])")});
  EXPECT_EQ(code(R"({"schema":"case-v2"})"), "unsupported-version");
  EXPECT_EQ(code(R"({"id":"a"})"), "missing-member");
  EXPECT_EQ(code(R"({"schema":"case-v1","dimension":3})"), "unsupported-dimension");
  EXPECT_EQ(code(R"({"schema":"case-v1","dimension":2,"id":""})"), "missing-member");
}

TEST(CaseFile, BothOperandsDrawOnTheSameLimits) {
  ReadLimits limits;
  limits.vertices = 9;
  EXPECT_EQ(
      refusal_of([&] { read_case_text(case_text(R"("scales":["1"])"), "input", limits); }).code(),
      "too-many-vertices");
}

}  // namespace
}  // namespace minkref::of_case
