#include "formats/mesh_format.hpp"

#include <algorithm>
#include <array>

#include "formats/format.hpp"
#include "formats/format_names.hpp"
#include "formats/mesh_formats.hpp"

namespace minkref {
namespace {

constexpr std::array<MeshFormatEntry, 5> table{{
    {MeshFormat::off, "off", "OFF 0 0 0", read_off, write_off, false},
    {MeshFormat::obj, "obj", "a comment", read_obj, write_obj, false},
    {MeshFormat::stl, "stl", "", read_stl, write_stl, false},
    {MeshFormat::ply, "ply", "", read_ply, write_ply, false},
    {MeshFormat::json, "json", R"({"vertices":[],"faces":[]})", read_mesh_json, write_mesh_json,
     true},
}};

}  // namespace

std::span<const MeshFormatEntry> mesh_format_table() { return table; }

const MeshFormatEntry& entry_of(MeshFormat format) {
  return *std::find_if(table.begin(), table.end(),
                       [&](const auto& entry) { return entry.format == format; });
}

std::string name(MeshFormat format) { return std::string(entry_of(format).name); }

MeshFormat mesh_format_named(std::string_view wanted) {
  return named(mesh_format_table(), wanted, "of polyhedra");
}

MeshFormat mesh_format_of_file(const std::string& path) {
  const std::string extension = extension_of(path);
  for (const MeshFormatEntry& entry : table) {
    if (extension == "." + std::string(entry.name)) return entry.format;
  }
  refuse_extension(mesh_format_table(), path, extension, "of polyhedra");
}

}  // namespace minkref
