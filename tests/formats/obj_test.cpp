#include "tests/formats/mesh.hpp"

namespace minkref::of_obj {
namespace {

Polyhedron obj(std::string_view text) { return mesh_in(text, MeshFormat::obj); }
std::string code(std::string_view text) { return mesh_code(text, MeshFormat::obj); }

const std::string vertices = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\n";
const std::string faces = "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

TEST(Obj, VerticesAreNumberedFromOne) { EXPECT_EQ(obj(vertices + faces), tetrahedron()); }

TEST(Obj, NegativeNumbersCountBackFromTheFace) {
  EXPECT_EQ(obj(vertices + "f -4 -3 -2\nf -4 -2 -1\nf -4 -1 -3\nf -3 -1 -2\n"), tetrahedron());
  EXPECT_EQ(obj("v 0 0 0\nv 0 1 0\nv 1 0 0\nf -3 -2 -1\nv 0 0 1\nf 1 -2 -1\nf 1 4 2\nf 2 4 3\n"),
            tetrahedron());
}

TEST(Obj, AFaceMayStandBeforeItsVertices) { EXPECT_EQ(obj(faces + vertices), tetrahedron()); }

TEST(Obj, TextureAndNormalsOfCornersAreSkipped) {
  EXPECT_EQ(
      obj(vertices + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 3//1 4//1\nf 1/1/1 4/1/1 2/1/1\n"
                     "f 2/-1/-1 4 3\n"),
      tetrahedron());
  for (const char* corner :
       {"1/", "1//", "1/2/3/4", "/1/2", "1.0", "x", "1/x", "+1", "1/1/", "--1"}) {
    EXPECT_EQ(code(vertices + "f " + corner + " 2 3\n"), "syntax") << corner;
  }
}

TEST(Obj, WordsOfGroupsAndMaterialsAreSkipped) {
  EXPECT_EQ(obj("# x\nmtllib a.mtl\no a\ng b c\ns off\nusemtl \\weird\n" + vertices + faces),
            tetrahedron());
}

TEST(Obj, WhatAPolyhedronDoesNotHaveIsRefusedWithItsLine) {
  for (const char* word : {"p 1", "l 1 2", "curv 0 1 1 2", "surf 0 1 0 1 1", "cstype bezier"}) {
    const BadInput refused = refusal_of_mesh(vertices + word + "\n" + faces, MeshFormat::obj);
    EXPECT_EQ(refused.code(), "unsupported-geometry") << word;
    EXPECT_EQ(refused.place().line, 5U);
  }
}

TEST(Obj, AMisspeltWordIsRefusedSoThatNoFaceIsLost) {
  EXPECT_EQ(code(vertices + "F 1 2 3\n"), "unknown-word");
  EXPECT_EQ(code("OFF\n0 0 0\n"), "unknown-word");
}

TEST(Obj, AFourthCoordinateIsOneOrRefused) {
  EXPECT_EQ(obj("v 1 2 3 1.0\n").vertices[0], space_point("1", "2", "3"));
  EXPECT_EQ(code("v 1 2 3 0.5\n"), "unsupported-geometry");
  EXPECT_EQ(code("v 1 2 3 x\n"), "not-a-number");
}

TEST(Obj, ColoursOfVerticesAreSkipped) {
  EXPECT_EQ(obj("v 1 2 3 0.5 0.5 0.5\n").vertices[0], space_point("1", "2", "3"));
  expect_code(code, "syntax", {"v 1 2 3 0.5 0.5\n", "v 1 2\n", "v\n"});
}

TEST(Obj, ABackslashJoinsTheNextLineAndFaultsNameTheFirst) {
  EXPECT_EQ(obj("v 0 0 \\\n0\nv 0 1 0\nv\\\r\n1 \\\r\n0 0\nv 0 0 1\n" + faces), tetrahedron());
  const BadInput refused = refusal_of_mesh(vertices + "f 1 \\\n2 \\\n9\n", MeshFormat::obj);
  EXPECT_EQ(refused.code(), "index-out-of-range");
  EXPECT_EQ(refused.place().line, 5U);
}

TEST(Obj, ACommentThatEndsInABackslashDoesNotSwallowTheNextLine) {
  EXPECT_EQ(obj("# C:\\models\\\n" + vertices + faces), tetrahedron());
}

TEST(Obj, AFaceThatNamesNoVertexIsRefusedWithTheNumberOfTheFile) {
  const auto problem = [](const std::string& corner) {
    const BadInput refused = refusal_of_mesh(vertices + "f 1 2 " + corner + "\n", MeshFormat::obj);
    EXPECT_EQ(refused.code(), "index-out-of-range");
    EXPECT_EQ(refused.place().face, 0U);
    EXPECT_EQ(refused.place().line, 5U);
    return refused.problem();
  };
  EXPECT_EQ(problem("5"), "the face names vertex 5, and the vertices are numbered from 1 to 4");
  EXPECT_EQ(problem("0"), "the face names vertex 0, and vertices are numbered from 1");
  EXPECT_EQ(problem("-5"), "the face names vertex -5, and 4 vertices stand before it");
  EXPECT_EQ(problem("4294967297"),
            "the face names vertex 4294967297, and vertices are numbered in 32 bits");
  EXPECT_EQ(refusal_of_mesh("f 1 2 3\n", MeshFormat::obj).problem(),
            "the face names vertex 1, and there is no vertex");
}

TEST(Obj, AFaceOfFewerThanThreeVerticesIsRefused) {
  EXPECT_EQ(code(vertices + "f 1 2\n"), "too-few-vertices");
  EXPECT_EQ(code(vertices + "f\n"), "too-few-vertices");
}

TEST(Obj, WithoutFacesItIsTheEmptySetAPointOrASegment) {
  EXPECT_TRUE(obj("# nothing\n").empty());
  EXPECT_TRUE(obj("v 0 0 0\n").is_point());
  EXPECT_TRUE(obj("v 0 0 0\nv 1 1 1\n").is_segment());
  EXPECT_EQ(code("v 0 0 0\nv 0 0 0\n"), "zero-length-edge");
  EXPECT_EQ(code(""), "empty-file");
}

}  // namespace
}  // namespace minkref::of_obj
