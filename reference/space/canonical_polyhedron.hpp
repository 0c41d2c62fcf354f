// A convex polyhedron's canonical form as text: two polyhedra are equal iff their texts are equal.
#pragma once

#include <string>

#include "reference/space/polyhedron.hpp"

namespace minkref::inline space {

/// Canonical JSON (docs/definitions.md, "Canonical form") of a surface already in canonical form:
/// `{"faces":[[0,1,2],...],"vertices":[["x","y","z"],...]}` without white space.
std::string canonical_json(const Polyhedron& canonical);

}  // namespace minkref::inline space
