// Polyhedra for tests, and checks of mesh refusals.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/read_mesh.hpp"
#include "formats/write_mesh.hpp"
#include "tests/formats/refusal.hpp"

namespace minkref {

inline const std::vector<MeshFormat> mesh_formats = {
    MeshFormat::off, MeshFormat::obj, MeshFormat::stl, MeshFormat::ply, MeshFormat::json};

inline SpacePoint space_point(const char* x, const char* y, const char* z) {
  return {parse_rational(x), parse_rational(y), parse_rational(z)};
}

/// The unit cube's corners: bit k of the index is coordinate k.
inline Polyhedron cube() {
  Polyhedron result;
  for (int i = 0; i < 8; ++i) result.vertices.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  result.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return result;
}

/// A tetrahedron whose faces first use vertices in ascending order.
inline Polyhedron tetrahedron(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                              const SpacePoint& d) {
  return {{a, b, c, d}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

inline Polyhedron tetrahedron() {
  return tetrahedron(space_point("0", "0", "0"), space_point("0", "1", "0"),
                     space_point("1", "0", "0"), space_point("0", "0", "1"));
}

inline Polyhedron mesh_in(std::string_view text, MeshFormat format) {
  return read_valid_mesh_text(text, format, "input").polyhedron;
}

inline BadInput refusal_of_mesh(std::string_view text, MeshFormat format,
                                const ReadLimits& limits = {}) {
  const BadInput refused = refusal_of([&] { read_valid_mesh_text(text, format, "input", limits); });
  EXPECT_EQ(refused.place().source, "input") << refused.what();
  return refused;
}

inline std::string mesh_code(std::string_view text, MeshFormat format,
                             const ReadLimits& limits = {}) {
  return refusal_of_mesh(text, format, limits).code();
}

/// Expects each face to be refused with its code, number and line; `refusal` puts a face into a
/// text.
template <class RefusalOf>
void expect_faulty_faces(RefusalOf&& refusal, std::size_t number, std::size_t line,
                         const std::vector<std::pair<std::string, std::string>>& faces) {
  for (const auto& [face, code] : faces) {
    const BadInput refused = refusal(face);
    EXPECT_EQ(refused.code(), code) << face;
    EXPECT_EQ(refused.place().face, number) << face;
    EXPECT_EQ(refused.place().line, line) << face;
  }
}

/// The bytes of an integer or a float.
template <class Value>
std::string bytes_of(Value value, std::endian order = std::endian::little) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  std::string text(raw.begin(), raw.end());
  if (order != std::endian::native) text = {text.rbegin(), text.rend()};
  return text;
}

/// The triangles of a polyhedron as binary STL, coordinates rounded to floats.
inline std::string binary_stl(const Polyhedron& polyhedron, std::string header = "binary") {
  header.resize(80, ' ');
  std::string text = header + bytes_of(static_cast<std::uint32_t>(polyhedron.faces.size()));
  const auto append = [&](const Rational& value) {
    text += bytes_of(static_cast<float>(to_double(value)));
  };
  for (const Face& face : polyhedron.faces) {
    for (int k = 0; k < 3; ++k) append(0);
    for (const std::uint32_t vertex : face) {
      append(polyhedron.vertices[vertex].x);
      append(polyhedron.vertices[vertex].y);
      append(polyhedron.vertices[vertex].z);
    }
    text += bytes_of(std::uint16_t{0});
  }
  return text;
}

/// A polyhedron as binary PLY: double coordinates, faces first if asked, and values to skip.
inline std::string binary_ply(const Polyhedron& polyhedron, std::endian order, bool faces_first) {
  const auto vertices = std::to_string(polyhedron.vertices.size());
  const auto faces = std::to_string(polyhedron.faces.size());
  const std::string vertex_header = "element vertex " + vertices +
                                    "\nproperty uchar red\nproperty double z\nproperty double x\n"
                                    "property list uchar short more\nproperty double y\n";
  const std::string face_header =
      "element face " + faces +
      "\nproperty float32 quality\nproperty list uint8 int32 vertex_index\n";
  std::string vertex_body, face_body;
  for (const SpacePoint& p : polyhedron.vertices) {
    vertex_body += bytes_of(std::uint8_t{200}) + bytes_of(to_double(p.z), order) +
                   bytes_of(to_double(p.x), order) + bytes_of(std::uint8_t{2}) +
                   bytes_of(std::int16_t{-1}, order) + bytes_of(std::int16_t{7}, order) +
                   bytes_of(to_double(p.y), order);
  }
  for (const Face& face : polyhedron.faces) {
    face_body += bytes_of(1.5F, order) + bytes_of(static_cast<std::uint8_t>(face.size()));
    for (const std::uint32_t v : face) face_body += bytes_of(static_cast<std::int32_t>(v), order);
  }
  const std::string name = order == std::endian::little ? "little" : "big";
  std::string text = "ply\nformat binary_" + name + "_endian 1.0\ncomment a \xff comment\n";
  text += faces_first ? face_header + vertex_header : vertex_header + face_header;
  text += "end_header\n";
  return text + (faces_first ? face_body + vertex_body : vertex_body + face_body);
}

}  // namespace minkref
