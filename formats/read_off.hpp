// Reader of OFF, the format of Geomview.
#pragma once

#include <string_view>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// `#` comments; the word OFF; the numbers of vertices, faces and (not looked at) edges, on the
/// same line or the next; one vertex a line; one face a line, its number of vertices before their
/// indices. Up to four words after them, the colour, are skipped. C, N and ST before OFF announce
/// colours, normals and texture coordinates of vertices: what follows the three coordinates is
/// skipped. Refuses everything else with its line. Linear.
MeshReading read_off(std::string_view text, Input& input);

}  // namespace minkref
