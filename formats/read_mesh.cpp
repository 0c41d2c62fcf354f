#include "formats/read_mesh.hpp"

#include "formats/file_text.hpp"
#include "formats/input.hpp"
#include "formats/json_text.hpp"
#include "formats/read_mesh_json.hpp"
#include "formats/read_obj.hpp"
#include "formats/read_off.hpp"
#include "formats/read_ply.hpp"
#include "formats/read_stl.hpp"

namespace minkref {

MeshReading read_mesh_text(std::string_view text, MeshFormat format, const std::string& source,
                           const ReadLimits& limits) {
  Input input(source, limits);
  const auto plain = [&](std::string_view empty_set) {
    return plain_text(text, source, limits, empty_set);
  };
  switch (format) {
    case MeshFormat::off:
      return read_off(plain("OFF 0 0 0"), input);
    case MeshFormat::obj:
      return read_obj(plain("a comment"), input);
    case MeshFormat::stl:
      return read_stl(text, input);
    case MeshFormat::ply:
      return read_ply(text, input);
    case MeshFormat::json:
      break;
  }
  const JsonText document(plain(R"({"vertices":[],"faces":[]})"), input);
  return read_mesh_json(document.root(), input);
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
