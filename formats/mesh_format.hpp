// The file formats of polyhedra and their names.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

enum class MeshFormat {
  off,   ///< Object File Format (Geomview), ASCII
  obj,   ///< Wavefront
  stl,   ///< triangles without common vertices; ASCII or binary
  ply,   ///< Polygon File Format (Stanford); ASCII or binary
  json,  ///< {"vertices":[["x","y","z"],...],"faces":[[0,1,2],...]}; exact
};

/// A row of the table, the only place that knows the single formats.
struct MeshFormatEntry {
  MeshFormat format;
  std::string_view name;       ///< also the extension of files
  std::string_view empty_set;  ///< as text; none for formats with binary files
  MeshReading (*read)(std::string_view text, Input& input);
  std::string (*write)(const Polyhedron& polyhedron);
  bool is_exact;  ///< writes every number
};

/// All formats: commands and Python take their lists from here.
std::span<const MeshFormatEntry> mesh_format_table();
const MeshFormatEntry& entry_of(MeshFormat format);

/// "off", "obj", "stl", "ply", "json".
std::string name(MeshFormat format);

/// The format with a given name. Throws BadInput ("unknown-format").
MeshFormat mesh_format_named(std::string_view name);

/// The format for a file name's extension (any case). Throws BadInput ("unknown-format").
MeshFormat mesh_format_of_file(const std::string& path);

}  // namespace minkref
