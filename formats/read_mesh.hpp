// Reads polyhedra from files and texts: the door to space.
#pragma once

#include <string>
#include <string_view>

#include "formats/limits.hpp"
#include "formats/mesh_format.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// Reads a polyhedron (docs/formats.md). Coordinates are the exact numbers of the text, or the
/// exact values of the bits. No face is turned; vertices stay apart, save for STL, a format without
/// vertices of its own. A file without faces gives a point (one vertex), a segment (two) or the
/// empty set (none). Nothing else is checked: see read_valid_mesh_text. `text` may be binary (STL,
/// PLY). Throws BadInput and LimitExceeded, which name source and line, vertex or face (from 0, as
/// the file counts), or the byte of a binary file; nothing else, save for std::bad_alloc. The
/// limits bound time and memory.
MeshReading read_mesh_text(std::string_view text, MeshFormat format, const std::string& source,
                           const ReadLimits& limits = {});

/// Reads a whole file first, then its text; the extension tells the format.
MeshReading read_mesh_file(const std::string& path, const ReadLimits& limits = {});

/// Read, then validated (`validate`); a refusal names the file, and the line of the face or the
/// vertex.
MeshReading read_valid_mesh_text(std::string_view text, MeshFormat format,
                                 const std::string& source, const ReadLimits& limits = {});
MeshReading read_valid_mesh_file(const std::string& path, const ReadLimits& limits = {});

}  // namespace minkref
