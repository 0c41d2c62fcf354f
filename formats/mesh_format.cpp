#include "formats/mesh_format.hpp"

#include <array>
#include <utility>

#include "formats/format.hpp"
#include "formats/message_text.hpp"
#include "reference/error.hpp"

namespace minkref {
namespace {

constexpr std::array<std::pair<MeshFormat, std::string_view>, 5> mesh_formats{{
    {MeshFormat::off, "off"},
    {MeshFormat::obj, "obj"},
    {MeshFormat::stl, "stl"},
    {MeshFormat::ply, "ply"},
    {MeshFormat::json, "json"},
}};

}  // namespace

std::string name(MeshFormat format) {
  for (const auto& [value, text] : mesh_formats) {
    if (value == format) return std::string(text);
  }
  return "unknown";
}

MeshFormat mesh_format_named(std::string_view wanted) {
  for (const auto& [value, text] : mesh_formats) {
    if (text == wanted) return value;
  }
  throw BadInput("unknown-format", in_quotes(wanted) + " is not a format of polyhedra",
                 "name one of off, obj, stl, ply, json");
}

MeshFormat mesh_format_of_file(const std::string& path) {
  const std::string extension = extension_of(path);
  for (const auto& [value, text] : mesh_formats) {
    if (extension == "." + std::string(text)) return value;
  }
  Place place;
  place.source = path;
  throw BadInput("unknown-format",
                 "the extension " + in_quotes(extension) + " does not name a format of polyhedra",
                 "give the file the extension .off, .obj, .stl, .ply or .json", place);
}

}  // namespace minkref
