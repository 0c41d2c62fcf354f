// The canonical form of a convex polyhedron as text: two are equal iff their texts are.
#pragma once

#include <string>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Canonical JSON (docs/definitions.md, "Canonical form") of a surface already in canonical form:
/// `{"faces":[[0,1,2],...],"vertices":[["x","y","z"],...]}` without white space.
std::string canonical_json(const Polyhedron& canonical);

}  // namespace minkref::inline space
