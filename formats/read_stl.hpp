// Reader of STL, ASCII and binary.
#pragma once

#include <string_view>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// Triangles without common vertices: equal coordinates are made one vertex, numbered in the order
/// of first use. Normals, names, the header and the attributes of a binary file are not looked at.
/// A file whose length is 84 + 50 n bytes, with n as its bytes 80 to 83 have it, is binary (no text
/// within the limits is so), every other one that begins with `solid` is ASCII, in any case of
/// letters, one solid. Binary coordinates are the exact values of their bits. O(n log n).
MeshReading read_stl(std::string_view file, Input& input);

}  // namespace minkref
