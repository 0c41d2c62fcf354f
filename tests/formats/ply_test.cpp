#include <limits>

#include "tests/formats/mesh.hpp"

namespace minkref::of_ply {
namespace {

Polyhedron ply(std::string_view text) { return mesh_in(text, MeshFormat::ply); }
std::string code(std::string_view text) { return mesh_code(text, MeshFormat::ply); }

const std::string format = "ply\nformat ascii 1.0\n";
const std::string coordinates = "property float x\nproperty float y\nproperty float z\n";
const std::string indices = "element face 4\nproperty list uchar int vertex_indices\n";
const std::string header = format + "element vertex 4\n" + coordinates + indices + "end_header\n";
const std::string vertices = "0 0 0\n0 1 0\n1 0 0\n0 0 1\n";
const std::string faces = "3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";

TEST(Ply, TheHeaderAnnouncesTheBody) {
  EXPECT_EQ(ply(header + vertices + faces), tetrahedron());
  const MeshReading reading = read_mesh_text(header + vertices + faces, MeshFormat::ply, "input");
  EXPECT_EQ(reading.vertex_lines, (std::vector<std::uint32_t>{10, 11, 12, 13}));
  EXPECT_EQ(reading.face_lines, (std::vector<std::uint32_t>{14, 15, 16, 17}));
}

TEST(Ply, CarriageReturnsAndAByteOrderMarkDoNotMatter) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : header + vertices + faces) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(ply(text), tetrahedron());
}

TEST(Ply, OtherElementsAndPropertiesAreSkippedInAnyOrder) {
  EXPECT_EQ(
      ply(format +
          "comment x\nobj_info y\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
          "element face 4\nproperty uchar red\nproperty list uchar uint vertex_index\n"
          "property list uchar float more\nelement vertex 4\nproperty list int int l\n"
          "property double z\nproperty int16 y\nproperty uint8 x\nelement empty 0\n"
          "element last 1\nproperty float32 q\nend_header\n"
          "0 1\n9 3 0 1 2 0\n9 3 0 2 3 1 0.5\n9 3 0 3 1 2 1 1\n9 3 1 3 2 0\n"
          "0 0 0 0\n1 7 0 1 0\n2 7 7 0 0 1\n0 1 0 0\nx\n"),
      tetrahedron());
}

TEST(Ply, ATextCoordinateIsTheNumberOfItsTextWhateverItsType) {
  const Polyhedron point =
      ply(format + "element vertex 1\n" + coordinates + "end_header\n0.1 1/3 1e-400\n");
  EXPECT_EQ(point.vertices[0].x, Rational(1, 10));
  EXPECT_EQ(point.vertices[0].y, Rational(1, 3));
  EXPECT_EQ(point.vertices[0].z, Rational(1, pow(Integer(10), 400)));
}

TEST(Ply, BinaryIsReadInBothOrdersOfBytes) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const bool faces_first : {false, true}) {
      EXPECT_EQ(ply(binary_ply(cube(), order, faces_first)), cube());
    }
  }
  const MeshReading reading =
      read_mesh_text(binary_ply(cube(), std::endian::big, true), MeshFormat::ply, "");
  EXPECT_TRUE(reading.vertex_lines.empty());
  EXPECT_TRUE(reading.face_lines.empty());
}

TEST(Ply, TheHeaderOfABinaryFileMayHaveCarriageReturns) {
  const std::string text = binary_ply(cube(), std::endian::big, false);
  const std::size_t body = text.find("end_header\n") + 11;
  std::string header_lines;
  for (const char c : text.substr(0, body)) {
    header_lines += c == '\n' ? "\r\n" : std::string(1, c);
  }
  EXPECT_EQ(ply(header_lines + text.substr(body)), cube());
}

std::string binary_point(const std::string& type, const std::string& x, const std::string& y,
                         const std::string& z, const std::string& order = "little") {
  std::string text = "ply\nformat binary_" + order + "_endian 1.0\nelement vertex 1\n";
  for (const char* axis : {"x", "y", "z"}) text += "property " + type + " " + axis + "\n";
  return text + "end_header\n" + x + y + z;
}

TEST(Ply, ABinaryNumberIsTheExactValueOfItsBits) {
  const auto point = [](const std::string& text) { return ply(text).vertices[0]; };
  const std::string zero(4, '\0');
  EXPECT_EQ(point(binary_point("float", bytes_of(0.1F), zero, zero)).x,
            Rational(13421773, 134217728));
  const std::string long_zero(8, '\0');
  EXPECT_EQ(point(binary_point("double", bytes_of(0.1), long_zero, long_zero)).x, from_double(0.1));
  EXPECT_EQ(point(binary_point("char", "\xff", "\x80", "\x7f")), space_point("-1", "-128", "127"));
  EXPECT_EQ(point(binary_point("uchar", "\xff", "\x80", "\x7f")), space_point("255", "128", "127"));
  const auto big = std::endian::big;
  EXPECT_EQ(
      point(binary_point("int16", bytes_of(std::int16_t{-2}, big), bytes_of(std::int16_t{300}, big),
                         "\x80" + std::string(1, '\0'), "big")),
      space_point("-2", "300", "-32768"));
  EXPECT_EQ(point(binary_point("ushort", "\xff\xff", "\xff\x01", "\x01\xff")),
            space_point("65535", "511", "65281"));
  EXPECT_EQ(point(binary_point("int", "\xff\xff\xff\xff", zero, zero)).x, -1);
  EXPECT_EQ(point(binary_point("uint", "\xff\xff\xff\xff", zero, zero)).x, 4294967295);
}

TEST(Ply, NaNAndInfinityAreRefusedWithTheByte) {
  const std::string zero(4, '\0');
  const std::string text =
      binary_point("float", zero, bytes_of(std::numeric_limits<float>::infinity()), zero);
  const BadInput refused = refusal_of_mesh(text, MeshFormat::ply);
  EXPECT_EQ(refused.code(), "not-a-number");
  EXPECT_EQ(refused.problem(),
            "at byte " + std::to_string(text.size() - 12) + ", a coordinate is infinite");
}

TEST(Ply, WithoutFacesItIsTheEmptySetAPointOrASegment) {
  EXPECT_TRUE(ply(format + "end_header\n").empty());
  EXPECT_TRUE(ply(format + "element vertex 0\nelement face 0\nend_header\n").empty());
  EXPECT_TRUE(
      ply(format + "element vertex 2\n" + coordinates + "end_header\n0 0 0\n1 1 1\n").is_segment());
}

TEST(Ply, AFaultyHeaderIsRefusedWithItsLine) {
  struct Fault {
    std::string text, code;
    std::size_t line;
  };
  for (const Fault& fault : std::vector<Fault>{
           {"plyx\n", "syntax", 1},
           {"ply\n", "truncated", 1},
           {"ply\nend_header\n", "syntax", 2},
           {"ply\nformat ascii\n", "syntax", 2},
           {"ply\nformat ascii 2.0\n", "unsupported-version", 2},
           {"ply\nformat binary_middle_endian 1.0\nend_header\n", "unsupported-encoding", 2},
           {format + "format ascii 1.0\n", "syntax", 3},
           {format + "property float x\n", "syntax", 3},
           {format + "elements vertex 4\n", "syntax", 3},
           {format + "element vertex\n", "syntax", 3},
           {format + "element vertex -1\n", "syntax", 3},
           {format + "element vertex 1\nproperty long x\n", "syntax", 4},
           {format + "element vertex 1\nproperty float\n", "syntax", 4},
           {format + "element vertex 1\nproperty list float int x\n", "syntax", 4},
           {format + "element nothing 9\nend_header\n", "syntax", 3},
           {format + "element vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
            "missing-property", 3},
           {format + "element vertex 1\nproperty float x\n" + coordinates + "end_header\n0 0 0 0\n",
            "duplicate-property", 3},
           {format + "element vertex 0\nelement vertex 0\nend_header\n", "duplicate-element", 4},
           {format + "element vertex 1\nproperty float x\nproperty float y\n" +
                "property list int int z\nend_header\n0 0 0\n",
            "wrong-type", 3},
           {format + "element face 1\nproperty int vertex_indices\nend_header\n0\n", "wrong-type",
            3},
           {format + "element face 1\nproperty list int float vertex_indices\nend_header\n0\n",
            "wrong-type", 3},
           {format + "element face 1\nproperty int x\nend_header\n0\n", "missing-property", 3},
           {format + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0\n",
            "unsupported-geometry", 3}}) {
    const BadInput refused = refusal_of_mesh(fault.text, MeshFormat::ply);
    EXPECT_EQ(refused.code(), fault.code) << fault.text;
    EXPECT_EQ(refused.place().line, fault.line) << fault.text;
  }
}

TEST(Ply, AFaultyBodyIsRefusedWithItsLine) {
  const auto line_of = [](const std::string& text, const std::string& expected) {
    const BadInput refused = refusal_of_mesh(text, MeshFormat::ply);
    EXPECT_EQ(refused.code(), expected) << text;
    return refused.place().line.value_or(0);
  };
  EXPECT_EQ(line_of(header + "0 0\n", "syntax"), 10U);
  EXPECT_EQ(line_of(header + "0 0 0 0\n", "syntax"), 10U);
  EXPECT_EQ(line_of(header + "0 0 x\n", "not-a-number"), 10U);
  EXPECT_EQ(line_of(header + vertices + "3 0 1\n", "syntax"), 14U);
  EXPECT_EQ(line_of(header + vertices + "3 0 1 2 3\n", "syntax"), 14U);
  EXPECT_EQ(line_of(header + vertices + "3 0 1 1.5\n", "syntax"), 14U);
  EXPECT_EQ(line_of(header + vertices + "-3 0 1 2\n", "syntax"), 14U);
  EXPECT_EQ(line_of(header + vertices + "4000000000 0 1 2\n", "syntax"), 14U);
  EXPECT_EQ(line_of(header + vertices + "2 0 1\n", "too-few-vertices"), 14U);
  EXPECT_EQ(line_of(header + vertices + "3 0 1 -2\n", "index-out-of-range"), 14U);
  EXPECT_EQ(
      line_of(header + vertices + "3 0 1 4\n3 0 2 3\n3 0 3 1\n3 1 3 2\n", "index-out-of-range"),
      14U);
  EXPECT_EQ(line_of(header + vertices + "3 0 1 2\n3 0 2 3\n3 0 3 1\n", "truncated"), 16U);
  EXPECT_EQ(line_of(header + vertices + faces + "3 1 3 2\n", "trailing-text"), 18U);
}

TEST(Ply, ABinaryBodyThatDoesNotFitIsRefusedWithTheByte) {
  const std::string good = binary_ply(cube(), std::endian::little, false);
  const BadInput cut = refusal_of_mesh(good.substr(0, good.size() - 1), MeshFormat::ply);
  EXPECT_EQ(cut.code(), "truncated");
  EXPECT_EQ(cut.problem(),
            "at byte " + std::to_string(good.size() - 4) + ", 4 bytes are due and 3 are left");
  const BadInput more = refusal_of_mesh(good + "x", MeshFormat::ply);
  EXPECT_EQ(more.code(), "trailing-text");
  EXPECT_EQ(more.problem(), "at byte " + std::to_string(good.size()) +
                                ", after the last element, 1 bytes are left");
}

TEST(Ply, ABinaryFaceThatNamesNoVertexIsRefusedWithTheByte) {
  for (const char* last : {"\xff\xff\xff\xff", "\x08\0\0\0"}) {
    std::string text = binary_ply(cube(), std::endian::little, false);
    text.replace(text.size() - 4, 4, last, 4);
    const BadInput refused = refusal_of_mesh(text, MeshFormat::ply);
    EXPECT_EQ(refused.code(), "index-out-of-range");
    EXPECT_EQ(refused.place().face, 5U);
    EXPECT_TRUE(
        refused.problem().starts_with("at byte " + std::to_string(text.size() - 21) + ", the face"))
        << refused.problem();
  }
}

TEST(Ply, ANulByteInTextIsRefused) {
  using namespace std::literals;
  EXPECT_EQ(code(header + "0 0 0\0\n"s), "nul-byte");
  EXPECT_EQ(code(""), "empty-file");
}

}  // namespace
}  // namespace minkref::of_ply
