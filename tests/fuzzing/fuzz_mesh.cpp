// Polyhedra: the first byte chooses the format. A body survives being written and read again, or it
// is refused.
#include <array>

#include "formats/read_mesh.hpp"
#include "formats/write_mesh.hpp"
#include "tests/fuzzing/round_trip.hpp"

namespace minkref::fuzzing {
namespace {

constexpr std::array formats{MeshFormat::off, MeshFormat::obj, MeshFormat::stl, MeshFormat::ply,
                             MeshFormat::json};

/// By a digit from 0.
MeshFormat format_of(std::uint8_t byte) { return formats[(byte & 15U) % formats.size()]; }

/// Every vertex and every face has a line, but those of binary files.
void check_lines(const MeshReading& reading, MeshFormat format, const std::string& text) {
  const bool binary = reading.vertex_lines.empty() && reading.face_lines.empty() &&
                      (format == MeshFormat::stl || format == MeshFormat::ply);
  if (binary) return;
  if (reading.vertex_lines.size() != reading.polyhedron.vertices.size() ||
      reading.face_lines.size() != reading.polyhedron.faces.size()) {
    broken("every vertex and every face has a line", text);
  }
}

/// A format that holds the polyhedron exactly gives it back; STL numbers vertices anew. Otherwise
/// coordinates are rounded, and STL cuts faces.
void check_written(const Polyhedron& polyhedron, MeshFormat format) {
  const bool exactly = writes_exactly(polyhedron, format);
  std::string text;
  try {
    text = write_mesh(polyhedron, format);
  } catch (const BadInput& refused) {
    if (exactly) broken("what a format holds exactly is written", refused.what());
    if (refused.mend().empty()) broken("a refusal says how to fix it", refused.what());
    return;
  }
  const Polyhedron again = read_mesh_text(text, format, "", output_limits()).polyhedron;
  const bool stl = format == MeshFormat::stl;
  if (exactly && again != (stl ? with_shared_vertices(polyhedron) : polyhedron)) {
    broken("write, then read, gives the same polyhedron", text);
  }
  if (!exactly && !stl &&
      (again.faces != polyhedron.faces || again.vertices.size() != polyhedron.vertices.size())) {
    broken("rounded coordinates leave the faces as they are", text);
  }
}

void check(std::string_view text, MeshFormat format) {
  MeshReading reading;
  try {
    reading = read_mesh_text(text, format, "input", input_limits());
  } catch (const BadInput& refused) {
    return check_refusal(refused);
  }
  check_lines(reading, format, std::string(text));
  for (const MeshFormat other : formats) check_written(reading.polyhedron, other);
  try {
    validate_as_read(reading, "input");
  } catch (const BadInput& refused) {
    check_refusal(refused);
  }
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace minkref::fuzzing;
  if (size == 0) return 0;
  check({reinterpret_cast<const char*>(data) + 1, size - 1}, format_of(data[0]));
  return 0;
}
