// Whether a sum in space is convex: a convex sum has the canonical form for convex polyhedra.
#pragma once

#include <optional>

#include "reference/space/convex/convex_polyhedron.hpp"
#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// Returns the set as a convex polyhedron if the set is convex and not empty. Each face of a convex
/// set is one convex polygon, and the polygons' corners are the set's vertices; convexity of the
/// assembled polyhedron is certified. Exact. O(n log n) for a convex set; a single face mostly
/// rules out other sets.
std::optional<ConvexPolyhedron> convex_polyhedron(const PolyhedralSet& set);

}  // namespace minkref::inline space
