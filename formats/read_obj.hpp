// Reader of OBJ, the format of Wavefront.
#pragma once

#include <string_view>

#include "formats/input.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// Lines `v x y z` and `f a b c ...`; a corner of a face is v, v/vt, v//vn or v/vt/vn, of which v
/// counts: the number of a vertex from 1, or from -1 backwards. `v x y z 1` and `v x y z r g b` are
/// read without what follows the coordinates. A backslash at the end of a line, comments aside,
/// joins the next. Words that name normals, texture, groups and materials are skipped. Refused:
/// points, lines, curves and surfaces (`p`, `l`, `curv`, ...), a fourth coordinate other than 1,
/// and words that the format does not have. Linear.
MeshReading read_obj(std::string_view text, Input& input);

}  // namespace minkref
