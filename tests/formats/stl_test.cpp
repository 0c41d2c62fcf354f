#include <limits>

#include "tests/formats/mesh.hpp"

namespace minkref::of_stl {
namespace {

Polyhedron stl(std::string_view text) { return mesh_in(text, MeshFormat::stl); }
std::string code(std::string_view text) { return mesh_code(text, MeshFormat::stl); }

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return " facet normal 0 0 nan\n  outer loop\n   vertex " + a + "\n   vertex " + b +
         "\n   vertex " + c + "\n  endloop\n endfacet\n";
}

const std::string tetra = "solid a name\n" + facet("0 0 0", "0 1 0", "1 0 0") +
                          facet("0 0 0", "1.0 0 0", "0 0 1") + facet("0 0 0", "0 0 1", "0 1 0") +
                          facet("0 1e0 0", "0 0 1", "10e-1 0 0") + "endsolid a name\n";

TEST(Stl, EqualCoordinatesAreMadeOneVertex) { EXPECT_EQ(stl(tetra), tetrahedron()); }

TEST(Stl, LinesAreThoseOfTheFirstUseOfEachVertex) {
  const MeshReading reading = read_mesh_text(tetra, MeshFormat::stl, "input");
  EXPECT_EQ(reading.vertex_lines, (std::vector<std::uint32_t>{4, 5, 6, 13}));
  EXPECT_EQ(reading.face_lines, (std::vector<std::uint32_t>{2, 9, 16, 23}));
}

TEST(Stl, WordsMayBeInAnyCaseAndLinesEndInCarriageReturns) {
  std::string text;
  for (const char c : tetra) {
    if (c == '\n') text += '\r';
    text += c >= 'a' && c <= 'z' && c != 'e' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  EXPECT_EQ(stl(text), tetrahedron());
}

TEST(Stl, CoordinatesOfTextAreExact) {
  const std::string text = "solid\n" + facet("0.1 0 0", "1 1/3 0", "0 1 0") + "endsolid\n";
  const Polyhedron soup = read_mesh_text(text, MeshFormat::stl, "").polyhedron;
  EXPECT_EQ(soup.vertices[0].x, Rational(1, 10));
  EXPECT_EQ(soup.vertices[1].y, Rational(1, 3));
}

TEST(Stl, BinaryAndAsciiAreTheSamePolyhedron) {
  EXPECT_EQ(stl(binary_stl(tetrahedron())), tetrahedron());
  const MeshReading reading = read_mesh_text(binary_stl(tetrahedron()), MeshFormat::stl, "");
  EXPECT_TRUE(reading.vertex_lines.empty());
  EXPECT_TRUE(reading.face_lines.empty());
}

TEST(Stl, ABinaryFileMayBeginWithTheWordSolid) {
  EXPECT_EQ(stl(binary_stl(tetrahedron(), "solid by an exporter\nfacet")), tetrahedron());
}

TEST(Stl, ABinaryFloatIsTheExactValueOfItsBits) {
  Polyhedron shape = tetrahedron();
  shape.vertices[3].z = Rational(1, 10);
  EXPECT_EQ(stl(binary_stl(shape)).vertices[3].z, from_double(static_cast<double>(0.1F)));
  EXPECT_EQ(stl(binary_stl(shape)).vertices[3].z, Rational(13421773, 134217728));
}

TEST(Stl, MinusZeroIsZero) {
  std::string text = binary_stl(tetrahedron());
  text.replace(84 + 12, 4, bytes_of(-0.0F));
  EXPECT_EQ(stl(text), tetrahedron());
}

TEST(Stl, NaNAndInfinityAreRefusedWithTheByte) {
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    std::string text = binary_stl(tetrahedron());
    text.replace(84 + 50 + 12 + 16, 4, bytes_of(value));
    const BadInput refused = refusal_of_mesh(text, MeshFormat::stl);
    EXPECT_EQ(refused.code(), "not-a-number");
    EXPECT_TRUE(refused.problem().starts_with("at byte 158, ")) << refused.problem();
    EXPECT_FALSE(refused.place().line.has_value());
  }
  EXPECT_EQ(code("solid\n" + facet("0 0 nan", "0 1 0", "1 0 0") + "endsolid\n"), "not-a-number");
}

TEST(Stl, ATriangleWithTwoEqualCornersIsRefused) {
  const BadInput refused = refusal_of_mesh("solid\n" + facet("0 0 0", "0 1 0", "1 0 0") +
                                               facet("0 0 0", "1 0 0", "0.0 0 0") + "endsolid\n",
                                           MeshFormat::stl);
  EXPECT_EQ(refused.code(), "repeated-vertex");
  EXPECT_EQ(refused.place().face, 1U);
  EXPECT_EQ(refused.place().line, 9U);
}

TEST(Stl, NoTriangleIsTheEmptySet) {
  EXPECT_TRUE(stl("solid\nendsolid\n").empty());
  EXPECT_TRUE(stl(binary_stl({})).empty());
}

TEST(Stl, SeveralSolidsAreOnePolyhedron) {
  const std::string other = "SOLID\n" + facet("5 0 0", "5 1 0", "6 0 0") + "endsolid b\n";
  const MeshReading reading = read_mesh_text(tetra + other, MeshFormat::stl, "input");
  EXPECT_EQ(reading.polyhedron.faces.size(), 5U);
  EXPECT_EQ(reading.polyhedron.vertices.size(), 7U);
  EXPECT_EQ(reading.warnings,
            std::vector<std::string>{"input: 2 solids are read as one polyhedron"});
  EXPECT_TRUE(read_mesh_text(tetra, MeshFormat::stl, "input").warnings.empty());
}

TEST(Stl, ALengthThatDoesNotFitIsRefused) {
  const std::string good = binary_stl(tetrahedron());
  EXPECT_EQ(code(good.substr(0, 40)), "syntax");  // 40 bytes of text
  EXPECT_EQ(code(good.substr(0, 83)), "truncated");
  EXPECT_EQ(code(good.substr(0, 100)), "truncated");
  EXPECT_EQ(code(good + std::string(1, '\0')), "trailing-text");
  EXPECT_EQ(code(good + good), "trailing-text");
  std::string huge = good;
  huge.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(code(huge), "truncated");
  std::string solid = binary_stl(tetrahedron(), "solid");
  solid.pop_back();
  EXPECT_EQ(code(solid), "truncated");
}

TEST(Stl, WrongStructureIsRefusedWithItsLine) {
  EXPECT_EQ(code("sold\nendsolid\n"), "syntax");
  EXPECT_EQ(code("solid\n"), "truncated");
  EXPECT_EQ(code("solid\n" + facet("0 0 0", "0 1 0", "1 0 0")), "truncated");
  EXPECT_EQ(code("solid\nendsolid\nfacet\n"), "trailing-text");
  expect_code(
      code, "syntax",
      {"solid\nfacet 0 0 1\nendsolid\n", "solid\n" + facet("0 0 0", "0 1 0", "1 0") + "endsolid\n",
       "solid\n" + facet("0 0 0", "0 1 0", "1 0 0\nvertex 1 1 0") + "endsolid\n"});
  const BadInput refused =
      refusal_of_mesh("solid\nfacet normal 0 0 1\nouter\nendsolid\n", MeshFormat::stl);
  EXPECT_EQ(refused.code(), "syntax");
  EXPECT_EQ(refused.place().line, 3U);
}

TEST(Stl, OtherFilesAreRefusedAsText) {
  using namespace std::literals;
  EXPECT_EQ(code(""), "empty-file");
  EXPECT_EQ(code("\xFF\xFEs\0o\0"sv), "not-utf8");
  EXPECT_EQ(code("OFF\n0 0 0\n"), "syntax");
}

}  // namespace
}  // namespace minkref::of_stl
