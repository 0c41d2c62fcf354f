// Reads polyhedra from files and texts: where to start in space.
#pragma once

#include <string>
#include <string_view>

#include "formats/limits.hpp"
#include "formats/mesh_format.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// Reads a polyhedron (docs/formats.md). Coordinates are the exact numbers of the text, or the
/// exact values of the bits. Faces are not turned; vertices stay apart, save for STL, which has
/// none of its own. A file without faces is a point (one vertex), a segment (two) or the empty set
/// (none). Nothing else is checked: see read_valid_mesh_text. `text` may be binary (STL, PLY).
/// Throws BadInput and LimitExceeded, which name source and line, vertex or face (from 0, in the
/// order of the file), in binary files the byte; nothing else, save for std::bad_alloc. Time and
/// memory are bounded by the limits.
MeshReading read_mesh_text(std::string_view text, MeshFormat format, const std::string& source,
                           const ReadLimits& limits = {});

/// The same from a file, read to its end first; the format by its extension.
MeshReading read_mesh_file(const std::string& path, const ReadLimits& limits = {});

/// Read, then validated (`validate`); a refusal names the file, and the line of the face or the
/// vertex.
MeshReading read_valid_mesh_text(std::string_view text, MeshFormat format,
                                 const std::string& source, const ReadLimits& limits = {});
MeshReading read_valid_mesh_file(const std::string& path, const ReadLimits& limits = {});

}  // namespace minkref
