#include "formats/mesh_reading.hpp"

#include "formats/refusal_place.hpp"

namespace minkref {
namespace {

Place with_line(Place place, const MeshReading& reading) {
  if (place.face && *place.face < reading.face_lines.size()) {
    place.line = reading.face_lines[*place.face];
  } else if (!place.vertices.empty() && place.vertices[0] < reading.vertex_lines.size()) {
    place.line = reading.vertex_lines[place.vertices[0]];
  }
  return place;
}

}  // namespace

void refuse_as_read(const MeshReading& reading, const std::string& source,
                    const std::function<void()>& check) {
  refuse_in_file(check, [&](const Place& place) { return with_line(place, reading); }, source);
}

void validate_as_read(const MeshReading& reading, const std::string& source) {
  refuse_as_read(reading, source, [&] { validate(reading.polyhedron); });
}

void validate_summand_as_read(const MeshReading& reading, const std::string& source) {
  refuse_as_read(reading, source, [&] { validate_summand(reading.polyhedron); });
}

}  // namespace minkref
