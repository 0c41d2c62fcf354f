// Reader of PLY, the format of Stanford, ASCII and binary.
#pragma once

#include <string_view>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// Version 1.0: the properties x, y and z of the elements `vertex`, and the list vertex_indices or
/// vertex_index of the elements `face`, in any order and of any type that fits; other elements and
/// properties are skipped, save for triangle strips, which are refused. ASCII: one element a line,
/// a coordinate is the exact number of its text, whatever its type. Binary: little or big endian, a
/// coordinate is the exact value of its bits. Linear.
MeshReading read_ply(std::string_view file, Input& input);

}  // namespace minkref
