// Reader of the plain JSON form of a polyhedron.
#pragma once

#include "formats/json_text.hpp"
#include "formats/mesh_reading.hpp"

namespace minkref {

/// Reads {"vertices":[[x,y,z],...],"faces":[[i,j,k,...],...]}: coordinates are strings or JSON
/// numbers, indices JSON integers from 0. Other members are refused. Linear.
MeshReading read_mesh_json(Json value, Input& input);

}  // namespace minkref
