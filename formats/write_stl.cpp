#include "formats/cut_face.hpp"
#include "formats/decimal.hpp"
#include "formats/mesh_formats.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref {
namespace {

/// Each coordinate once: most vertices stand in six triangles.
std::vector<std::string> vertex_lines(const Polyhedron& polyhedron) {
  std::vector<std::string> lines;
  for (const SpacePoint& p : polyhedron.vertices) {
    lines.push_back("vertex " + decimal(p.x) + " " + decimal(p.y) + " " + decimal(p.z) + "\n");
  }
  return lines;
}

void append(std::string& text, const Face& triangle, const std::vector<std::string>& lines) {
  look_for_interrupt();
  text += "facet normal 0 0 0\nouter loop\n";
  for (const std::uint32_t vertex : triangle) text += lines[vertex];
  text += "endloop\nendfacet\n";
}

}  // namespace

std::string write_stl(const Polyhedron& polyhedron) {
  if (polyhedron.faces.empty() && !polyhedron.empty()) {
    throw BadInput("not-representable", "STL has no points and no segments",
                   "write the polyhedron as OFF, OBJ, PLY or JSON");
  }
  const std::vector<std::string> lines = vertex_lines(polyhedron);
  std::string text = "solid minkref\n";
  for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
    const auto triangles = triangles_of(polyhedron.faces[f], polyhedron.vertices);
    if (!triangles) {
      Place place;
      place.face = f;
      throw BadInput(
          "not-representable", "STL has triangles only, and the face is not planar and simple",
          "cut the face into triangles, or write the polyhedron as OFF, OBJ, PLY or JSON", place);
    }
    for (const Face& triangle : *triangles) append(text, triangle, lines);
  }
  return text + "endsolid minkref\n";
}

}  // namespace minkref
