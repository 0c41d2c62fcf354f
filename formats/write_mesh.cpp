#include "formats/write_mesh.hpp"

#include <algorithm>

#include "formats/decimal.hpp"
#include "formats/mesh_formats.hpp"
#include "reference/error.hpp"
#include "reference/interrupt.hpp"

namespace minkref {
namespace {

std::string decimals(const SpacePoint& p) {
  return decimal(p.x) + " " + decimal(p.y) + " " + decimal(p.z);
}

/// The numbers of the vertices, each after a blank.
std::string indices(const Face& face, std::size_t first_number) {
  std::string text;
  look_for_interrupt();
  for (const std::uint32_t vertex : face) text += " " + std::to_string(vertex + first_number);
  return text;
}

void append_body(std::string& text, const Polyhedron& polyhedron) {
  for (const SpacePoint& vertex : polyhedron.vertices) text += decimals(vertex) + "\n";
  for (const Face& face : polyhedron.faces) {
    text += std::to_string(face.size()) + indices(face, 0) + "\n";
  }
}

bool has_decimals(const SpacePoint& p) {
  return has_exact_decimal(p.x) && has_exact_decimal(p.y) && has_exact_decimal(p.z);
}

/// Whether STL, a format without vertices of its own, loses nothing but the vertices' order.
bool is_soup_of_triangles(const Polyhedron& polyhedron) {
  if (polyhedron.empty()) return true;
  return polyhedron.is_solid() &&
         std::all_of(polyhedron.faces.begin(), polyhedron.faces.end(),
                     [](const Face& face) { return face.size() == 3; }) &&
         with_shared_vertices(polyhedron).vertices.size() == polyhedron.vertices.size();
}

}  // namespace

std::string write_mesh(const Polyhedron& polyhedron, MeshFormat format) {
  return entry_of(format).write(polyhedron);
}

bool writes_exactly(const Polyhedron& polyhedron, MeshFormat format) {
  if (entry_of(format).is_exact) return true;
  if (format == MeshFormat::stl && !is_soup_of_triangles(polyhedron)) return false;
  return std::all_of(polyhedron.vertices.begin(), polyhedron.vertices.end(), has_decimals);
}

std::string write_off(const Polyhedron& polyhedron) {
  std::string text = "OFF\n" + std::to_string(polyhedron.vertices.size()) + " " +
                     std::to_string(polyhedron.faces.size()) + " 0\n";
  append_body(text, polyhedron);
  return text;
}

std::string write_obj(const Polyhedron& polyhedron) {
  // A file without any line would look like a lost file.
  if (polyhedron.empty()) return "# the empty set\n";
  std::string text;
  for (const SpacePoint& vertex : polyhedron.vertices) text += "v " + decimals(vertex) + "\n";
  for (const Face& face : polyhedron.faces) text += "f" + indices(face, 1) + "\n";
  return text;
}

std::string write_ply(const Polyhedron& polyhedron) {
  const bool short_faces = std::all_of(polyhedron.faces.begin(), polyhedron.faces.end(),
                                       [](const Face& face) { return face.size() < 256; });
  std::string text = "ply\nformat ascii 1.0\nelement vertex " +
                     std::to_string(polyhedron.vertices.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(polyhedron.faces.size()) + "\nproperty list " +
                     (short_faces ? "uchar" : "uint") + " uint vertex_indices\nend_header\n";
  append_body(text, polyhedron);
  return text;
}

std::string write_mesh_json(const Polyhedron& polyhedron) {
  std::string text = "{\"faces\":[";
  for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
    const Face& face = polyhedron.faces[f];
    text += f > 0 ? ",[" : "[";
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (k > 0) text += ",";
      text += std::to_string(face[k]);
    }
    text += "]";
  }
  text += "],\"vertices\":[";
  for (std::size_t v = 0; v < polyhedron.vertices.size(); ++v) {
    const SpacePoint& p = polyhedron.vertices[v];
    text += v > 0 ? ",[\"" : "[\"";
    text += to_string(p.x) + "\",\"" + to_string(p.y) + "\",\"" + to_string(p.z) + "\"]";
  }
  return text + "]}\n";
}

}  // namespace minkref
