#include "tests/formats/mesh.hpp"

namespace minkref::of_off {
namespace {

Polyhedron off(std::string_view text) { return mesh_in(text, MeshFormat::off); }
std::string code(std::string_view text) { return mesh_code(text, MeshFormat::off); }

const std::string vertices = "0 0 0\n0 1 0\n1 0 0\n0 0 1\n";
const std::string faces = "3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";
const std::string tetra = "OFF\n4 4 6\n" + vertices + faces;

TEST(Off, CommentsBlankLinesAndTheNumberOfEdgesDoNotMatter) {
  EXPECT_EQ(off(tetra), tetrahedron());
  EXPECT_EQ(off("# 1\n\nOFF # 2\n\n4 4 0 # 3\n" + vertices + "\n# 4\n" + faces + "\n\n"),
            tetrahedron());
  EXPECT_EQ(off("OFF\n4 4\n" + vertices + faces), tetrahedron());
}

TEST(Off, TheCountsMayStandOnTheLineOfTheHeader) {
  EXPECT_EQ(off("OFF 4 4 6\n" + vertices + faces), tetrahedron());
}

TEST(Off, CarriageReturnsAByteOrderMarkAndAMissingLastLineBreakDoNotMatter) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : tetra) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(off(text), tetrahedron());
  EXPECT_EQ(off(tetra.substr(0, tetra.size() - 1)), tetrahedron());
}

TEST(Off, ColoursOfFacesAndVerticesAreSkipped) {
  EXPECT_EQ(off("OFF\n4 4 6\n" + vertices +
                "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1\n3 0 3 1 7\n3 1 3 2\n"),
            tetrahedron());
  EXPECT_EQ(off("COFF\n4 4 6\n0 0 0 1 2 3 4\n0 1 0 1 2 3 4\n1 0 0 1 2 3 4\n0 0 1 1 2 3\n" + faces),
            tetrahedron());
  EXPECT_EQ(off("STCNOFF\n4 4 6\n0 0 0 1\n0 1 0 1\n1 0 0 1\n0 0 1 1\n" + faces), tetrahedron());
  EXPECT_EQ(code("OFF\n4 4 6\n0 0 0 9\n0 1 0\n1 0 0\n0 0 1\n" + faces), "syntax");
  EXPECT_EQ(code("OFF\n4 4 6\n" + vertices + "3 0 1 2 1 2 3 4 5\n3 0 2 3\n3 0 3 1\n3 1 3 2\n"),
            "syntax");
}

TEST(Off, CoordinatesAreTheExactNumbersOfTheText) {
  const Polyhedron point = off("OFF 1 0 0\n0.1 -3/7 1e400\n");
  ASSERT_TRUE(point.is_point());
  EXPECT_EQ(point.vertices[0].x, Rational(1, 10));
  EXPECT_EQ(point.vertices[0].y, Rational(-3, 7));
  EXPECT_EQ(point.vertices[0].z, Rational(pow(Integer(10), 400)));
}

TEST(Off, WithoutFacesItIsTheEmptySetAPointOrASegment) {
  EXPECT_TRUE(off("OFF\n0 0 0\n").empty());
  EXPECT_TRUE(off("OFF 1 0 0\n1 2 3").is_point());
  EXPECT_TRUE(off("OFF 2 0 0\n1 2 3\n4 5 6").is_segment());
  EXPECT_EQ(code("OFF 3 0 0\n1 2 3\n4 5 6\n7 8 9"), "too-few-faces");
}

TEST(Off, FacesAreNotTurned) {
  EXPECT_EQ(code("OFF\n4 4 6\n" + vertices + "3 0 2 1\n3 0 2 3\n3 0 3 1\n3 1 3 2\n"),
            "wrong-orientation");
  EXPECT_EQ(code("OFF\n4 4 6\n" + vertices + "3 0 2 1\n3 0 3 2\n3 0 1 3\n3 1 2 3\n"),
            "wrong-orientation");
}

TEST(Off, HeadersOfOtherKindsAreRefused) {
  EXPECT_EQ(code("OFF BINARY\n1 2 3"), "unsupported-encoding");
  EXPECT_EQ(code("4OFF\n0 0 0\n"), "unsupported-geometry");
  EXPECT_EQ(code("nOFF\n3\n0 0 0\n"), "unsupported-geometry");
  expect_code(code, "syntax",
              {"OFF4 4 6\n", "4 4 6\n" + vertices + faces, "OFF\n4\n", "OFF\n4 4 6 7\n",
               "OFF\n-4 4 6\n", "OFF\n4 4 x\n"});
  EXPECT_EQ(code("# OFF\n"), "truncated");
}

TEST(Off, CountsThatDoNotFitAreRefused) {
  EXPECT_EQ(code("OFF\n5 4 6\n" + vertices + faces), "syntax");
  EXPECT_EQ(code("OFF\n4 5 6\n" + vertices + faces), "truncated");
  EXPECT_EQ(code("OFF\n4 3 6\n" + vertices + faces), "trailing-text");
  EXPECT_EQ(code("OFF\n3 4 6\n" + vertices + faces), "too-few-vertices");
}

TEST(Off, AFaultyFaceIsRefusedWithItsNumberAndItsLine) {
  const auto faulty = [](const std::string& face) {
    return refusal_of_mesh("OFF\n4 4 6\n" + vertices + "3 0 1 2\n3 0 2 3\n" + face + "\n3 1 3 2\n",
                           MeshFormat::off);
  };
  expect_faulty_faces(faulty, 2, 9,
                      {{"3 0 3 4", "index-out-of-range"},
                       {"3 0 3 -1", "index-out-of-range"},
                       {"3 0 3 5000000000", "index-out-of-range"},
                       {"2 0 3", "too-few-vertices"},
                       {"0", "too-few-vertices"},
                       {"4 0 3 1", "syntax"},
                       {"3 0 3 1.0", "syntax"},
                       {"4000000000 0 3 1", "syntax"},
                       {"3 0 3 0", "repeated-vertex"}});
  EXPECT_EQ(
      std::string(faulty("3 0 3 4").what()),
      "input: line 9: face 2: the face names vertex 4, and the vertices are numbered from 0 to "
      "3 [index-out-of-range]. To fix it: correct the number, or add the vertex");
}

TEST(Off, AFaultyVertexIsRefusedWithItsNumberAndItsLine) {
  for (const auto& [vertex, code] :
       std::vector<std::pair<std::string, std::string>>{{"1 0", "syntax"},
                                                        {"1 0 x", "not-a-number"},
                                                        {"nan 0 0", "not-a-number"},
                                                        {"0 -inf 0", "not-a-number"},
                                                        {"0 1/0 0", "zero-denominator"}}) {
    const BadInput refused = refusal_of_mesh(
        "OFF\n4 4 6\n0 0 0\n0 1 0\n" + vertex + "\n0 0 1\n" + faces, MeshFormat::off);
    EXPECT_EQ(refused.code(), code) << vertex;
    EXPECT_EQ(refused.place().vertices, std::vector<std::size_t>{2}) << vertex;
    EXPECT_EQ(refused.place().line, 5U) << vertex;
  }
}

TEST(Off, RefusalsOfValidationNameTheLine) {
  const BadInput open =
      refusal_of_mesh("OFF\n4 3 6\n" + vertices + "3 0 1 2\n3 0 2 3\n3 0 3 1\n", MeshFormat::off);
  EXPECT_EQ(open.code(), "open-mesh");
  EXPECT_EQ(open.place().line, 7U + *open.place().face);
  const BadInput unused =
      refusal_of_mesh("OFF\n5 4 6\n" + vertices + "9 9 9\n" + faces, MeshFormat::off);
  EXPECT_EQ(unused.code(), "unused-vertex");
  EXPECT_EQ(unused.place().line, 7U);
}

}  // namespace
}  // namespace minkref::of_off
