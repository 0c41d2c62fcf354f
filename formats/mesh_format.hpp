// The file formats of polyhedra and their names.
#pragma once

#include <string>
#include <string_view>

namespace minkref {

enum class MeshFormat {
  off,   ///< Object File Format (Geomview), ASCII
  obj,   ///< Wavefront
  stl,   ///< triangles without common vertices; ASCII or binary
  ply,   ///< Polygon File Format (Stanford); ASCII or binary
  json,  ///< {"vertices":[["x","y","z"],...],"faces":[[0,1,2],...]}; exact
};

/// "off", "obj", "stl", "ply", "json".
std::string name(MeshFormat format);

/// The format of that name. Throws BadInput ("unknown-format").
MeshFormat mesh_format_named(std::string_view name);

/// The format by the extension of a file name (any case). Throws BadInput ("unknown-format").
MeshFormat mesh_format_of_file(const std::string& path);

}  // namespace minkref
