#include "formats/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref {

Place MeshBuilder::vertex_place(std::size_t position) const {
  Place place = at_line(positions_ == Positions::lines ? position : 0);
  place.vertices.push_back(vertices());
  return place;
}

Place MeshBuilder::face_place(std::size_t face) const {
  Place place = at_line(positions_ == Positions::lines ? face_positions_[face] : 0);
  place.face = face;
  return place;
}

std::string MeshBuilder::at_byte(std::size_t position) const {
  return positions_ == Positions::bytes ? "at byte " + std::to_string(position) + ", " : "";
}

void MeshBuilder::refuse_vertex(const std::string& code, const std::string& problem,
                                const std::string& mend, std::size_t position) const {
  input_.refuse(code, at_byte(position) + problem, mend, vertex_place(position));
}

void MeshBuilder::refuse_face(const std::string& code, const std::string& problem,
                              const std::string& mend) const {
  const std::size_t face = faces() - 1;
  input_.refuse(code, at_byte(face_positions_[face]) + problem, mend, face_place(face));
}

template <class Number>
void MeshBuilder::add_vertex(const std::array<Number, 3>& coordinates, std::size_t position) {
  const Place place = vertex_place(position);
  input_.count_vertex(place);
  SpacePoint point;
  point.x = input_.number(coordinates[0], place);
  point.y = input_.number(coordinates[1], place);
  point.z = input_.number(coordinates[2], place);
  mesh_.vertices.push_back(std::move(point));
  vertex_positions_.push_back(static_cast<std::uint32_t>(position));
}

void MeshBuilder::vertex(const std::array<std::string_view, 3>& coordinates, std::size_t position) {
  add_vertex(coordinates, position);
}

void MeshBuilder::vertex(const std::array<double, 3>& coordinates, std::size_t position) {
  for (const double value : coordinates) {
    if (std::isfinite(value)) continue;
    refuse_vertex("not-a-number",
                  std::string("a coordinate is ") + (std::isnan(value) ? "NaN" : "infinite"),
                  "leave the vertex out, or replace the coordinate by a finite one", position);
  }
  add_vertex(coordinates, position);
}

void MeshBuilder::begin_face(std::size_t position) {
  mesh_.faces.emplace_back();
  face_positions_.push_back(static_cast<std::uint32_t>(position));
  input_.count_face(face_place(faces() - 1));
}

void MeshBuilder::corner(std::uint64_t vertex) {
  if (vertex >= std::numeric_limits<std::uint32_t>::max()) {
    refuse_corner(std::to_string(vertex + first_number_), "vertices are numbered in 32 bits");
  }
  input_.count_face_corner(face_place(faces() - 1));
  mesh_.faces.back().push_back(static_cast<std::uint32_t>(vertex));
}

void MeshBuilder::refuse_corner(const std::string& number, const std::string& why) const {
  refuse_index(faces() - 1, number, why);
}

void MeshBuilder::refuse_index(std::size_t face, const std::string& number,
                               const std::string& why) const {
  input_.refuse("index-out-of-range",
                at_byte(face_positions_[face]) + "the face names vertex " + number + ", and " + why,
                "correct the number, or add the vertex", face_place(face));
}

void MeshBuilder::end_face() {
  const std::size_t size = mesh_.faces.back().size();
  if (size >= 3) return;
  refuse_face("too-few-vertices",
              "the face has " + std::to_string(size) + (size == 1 ? " vertex" : " vertices") +
                  ", a face has three or more",
              "complete the face, or leave it out");
}

std::string MeshBuilder::known_numbers() const {
  if (vertices() == 0) return "there is no vertex";
  return "the vertices are numbered from " + std::to_string(first_number_) + " to " +
         std::to_string(first_number_ + vertices() - 1);
}

MeshReading MeshBuilder::finish() {
  for (std::size_t f = 0; f < faces(); ++f) {
    look_for_interrupt();
    for (const std::uint32_t vertex : mesh_.faces[f]) {
      if (vertex < vertices()) continue;
      refuse_index(f, std::to_string(vertex + first_number_), known_numbers());
    }
  }
  MeshReading reading;
  reading.polyhedron = std::exchange(mesh_, {});
  reading.warnings = input_.take_warnings();
  if (positions_ == Positions::lines) {
    reading.vertex_lines = std::move(vertex_positions_);
    reading.face_lines = std::move(face_positions_);
  }
  return reading;
}

MeshReading MeshBuilder::finish_shared() {
  MeshReading apart = finish();
  MeshReading shared;
  shared.polyhedron = with_shared_vertices(apart.polyhedron);
  shared.warnings = std::move(apart.warnings);
  shared.face_lines = std::move(apart.face_lines);
  if (apart.vertex_lines.empty()) return shared;
  // Vertices have the order of their first use.
  for (std::size_t f = 0; f < shared.polyhedron.faces.size(); ++f) {
    const Face& before = apart.polyhedron.faces[f];
    const Face& after = shared.polyhedron.faces[f];
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (after[k] < shared.vertex_lines.size()) continue;
      shared.vertex_lines.push_back(apart.vertex_lines[before[k]]);
    }
  }
  return shared;
}

}  // namespace minkref
