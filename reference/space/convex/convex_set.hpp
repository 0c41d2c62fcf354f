// Whether a sum in space is convex: then it has the canonical form of a convex polyhedron.
#pragma once

#include <optional>

#include "reference/space/convex/convex_polyhedron.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// The set as a convex polyhedron, where it is convex and not empty. Each face of a convex set is
/// one convex polygon, and the corners of these are its vertices; what they are put together to is
/// certified to be convex. Exact. O(n log n) for a convex set; others are mostly told by a face.
std::optional<ConvexPolyhedron> convex_polyhedron(const PolyhedralSet& set);

}  // namespace minkref::inline space
