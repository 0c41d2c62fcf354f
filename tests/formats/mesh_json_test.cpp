#include "tests/formats/mesh.hpp"

namespace minkref::of_mesh_json {
namespace {

Polyhedron json(std::string_view text) { return mesh_in(text, MeshFormat::json); }
std::string code(std::string_view text) { return mesh_code(text, MeshFormat::json); }

std::string with_faces(const std::string& faces) {
  return R"({"vertices":[[0,0,0],["0","1","0"],[1.0,0,0],[0,0,"2/2"]],)"
         "\n\"faces\":[" +
         faces + "]}";
}

TEST(MeshJson, CoordinatesAreStringsOrNumbersAndExact) {
  EXPECT_EQ(json(with_faces("[0,1,2],[0,2,3],[0,3,1],[1,3,2]")), tetrahedron());
  const Polyhedron point = json(R"({"faces":[],"vertices":[[0.1,"1/3",1e400]]})");
  EXPECT_EQ(point.vertices[0].x, Rational(1, 10));
  EXPECT_EQ(point.vertices[0].y, Rational(1, 3));
  EXPECT_EQ(point.vertices[0].z, Rational(pow(Integer(10), 400)));
}

TEST(MeshJson, WithoutFacesItIsTheEmptySetAPointOrASegment) {
  EXPECT_TRUE(json(R"({"vertices":[],"faces":[]})").empty());
  EXPECT_TRUE(json(R"({"vertices":[[1,2,3]],"faces":[]})").is_point());
  EXPECT_TRUE(json(R"({"vertices":[[1,2,3],[3,2,1]],"faces":[]})").is_segment());
}

TEST(MeshJson, WrongStructureIsRefused) {
  EXPECT_EQ(code("[]"), "wrong-type");
  EXPECT_EQ(code("{}"), "missing-member");
  EXPECT_EQ(code(R"({"vertices":[]})"), "missing-member");
  EXPECT_EQ(code(R"({"vertices":[],"faces":[],"face":[]})"), "unknown-member");
  EXPECT_EQ(code(R"({"vertices":[],"vertices":[],"faces":[]})"), "duplicate-member");
  EXPECT_EQ(code(R"({"polygons":[]})"), "unknown-member");
  expect_code(code, "wrong-type",
              {R"({"vertices":{},"faces":[]})", R"({"vertices":[],"faces":{}})",
               R"({"vertices":[[1,2]],"faces":[]})", R"({"vertices":[[1,2,3,4]],"faces":[]})"});
  expect_code(code, "not-a-number",
              {R"({"vertices":[[1,2,null]],"faces":[]})", R"({"vertices":[[1,2,NaN]],"faces":[]})",
               R"({"vertices":[[1,2,"inf"]],"faces":[]})"});
  EXPECT_EQ(code(R"({"vertices":[],"faces":[)"), "truncated");
  EXPECT_EQ(code(R"({"vertices":[],"faces":[]} 1)"), "trailing-text");
}

TEST(MeshJson, AFaultyFaceIsRefusedWithItsNumberAndItsLine) {
  const auto faulty = [](const std::string& face) {
    return refusal_of_mesh(with_faces("[0,1,2],\n" + face + ",[0,3,1],[1,3,2]"), MeshFormat::json);
  };
  expect_faulty_faces(faulty, 1, 3,
                      {{"[0,2,4]", "index-out-of-range"},
                       {"[0,2,-1]", "index-out-of-range"},
                       {"[0,2,5000000000]", "index-out-of-range"},
                       {"[0,2]", "too-few-vertices"},
                       {"[]", "too-few-vertices"},
                       {"[0,2,1.0]", "syntax"},
                       {"[0,2,1e0]", "syntax"},
                       {"[0,2,\"3\"]", "wrong-type"},
                       {"3", "wrong-type"},
                       {"[0,2,0]", "repeated-vertex"}});
}

}  // namespace
}  // namespace minkref::of_mesh_json
