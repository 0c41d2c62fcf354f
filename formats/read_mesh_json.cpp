#include <array>
#include <string>

#include "formats/json_object.hpp"
#include "formats/json_text.hpp"
#include "formats/mesh_builder.hpp"
#include "formats/mesh_formats.hpp"
#include "formats/message_text.hpp"
#include "formats/read_json.hpp"

namespace minkref {
namespace {

void read_vertex(Json value, MeshBuilder& mesh) {
  if (!value.is(JsonKind::array) || value.size() != 3) {
    mesh.refuse_vertex("wrong-type", "a vertex must be an array of three numbers",
                       "write [\"x\", \"y\", \"z\"]", value.line());
  }
  Place place = at_line(value.line());
  place.vertices.push_back(mesh.vertices());
  std::array<std::string, 3> texts;
  std::size_t axis = 0;
  for (const Json number : value) {
    texts[axis++] = number_text(number, JsonNumbers::any, mesh.input(), place);
  }
  mesh.vertex({std::string_view(texts[0]), std::string_view(texts[1]), std::string_view(texts[2])},
              value.line());
}

void read_face(Json value, MeshBuilder& mesh) {
  mesh.begin_face(value.line());
  if (!value.is(JsonKind::array)) {
    mesh.refuse_face("wrong-type", "a face must be an array, not " + describe(value.kind()),
                     "write the indices of its vertices, as in [0, 1, 2]");
  }
  Place place = at_line(value.line());
  place.face = mesh.faces() - 1;
  for (const Json index : value) {
    if (!index.is(JsonKind::number)) {
      mesh.refuse_face("wrong-type",
                       "the index of a vertex must be a number, not " + describe(index.kind()),
                       "write it without quotes, as in [0, 1, 2]");
    }
    if (index.text().starts_with('-')) {
      mesh.refuse_corner(printable(index.text().substr(0, 20)), "vertices are numbered from 0");
    }
    mesh.corner(mesh.input().whole_number(index.text(), "the number of a vertex", place));
  }
  mesh.end_face();
}

MeshReading read_mesh_json(Json value, Input& input) {
  const JsonObject members(value, input, "a polyhedron", {"vertices", "faces"},
                           JsonObject::Others::refused);
  const Json vertices = members.require("vertices");
  const Json faces = members.require("faces");
  expect(vertices, JsonKind::array, "vertices", input);
  expect(faces, JsonKind::array, "faces", input);
  MeshBuilder mesh(input, Positions::lines);
  for (const Json vertex : vertices) read_vertex(vertex, mesh);
  for (const Json face : faces) read_face(face, mesh);
  return mesh.finish();
}

}  // namespace

MeshReading read_mesh_json(std::string_view text, Input& input) {
  const JsonText document(text, input);
  return read_mesh_json(document.root(), input);
}

}  // namespace minkref
