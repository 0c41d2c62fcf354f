#include "formats/read_mesh.hpp"

#include "formats/file_text.hpp"
#include "formats/input.hpp"

namespace minkref {

MeshReading read_mesh_text(std::string_view text, MeshFormat format, const std::string& source,
                           const ReadLimits& limits) {
  Input input(source, limits);
  const MeshFormatEntry& entry = entry_of(format);
  if (!entry.empty_set.empty()) text = plain_text(text, source, limits, entry.empty_set);
  return entry.read(text, input);
}

MeshReading read_mesh_file(const std::string& path, const ReadLimits& limits) {
  const std::string text = read_whole_file(path, limits);
  return read_mesh_text(text, mesh_format_of_file(path), path, limits);
}

MeshReading read_valid_mesh_text(std::string_view text, MeshFormat format,
                                 const std::string& source, const ReadLimits& limits) {
  MeshReading reading = read_mesh_text(text, format, source, limits);
  validate_as_read(reading, source);
  return reading;
}

MeshReading read_valid_mesh_file(const std::string& path, const ReadLimits& limits) {
  MeshReading reading = read_mesh_file(path, limits);
  validate_as_read(reading, path);
  return reading;
}

}  // namespace minkref
