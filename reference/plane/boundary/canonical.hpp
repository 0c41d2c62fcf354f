// A polygon set's canonical form: two sets are equal iff their canonical forms agree.
#pragma once

#include <string>
#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// Canonical JSON text (docs/definitions.md, "Canonical form") of a set already in canonical form.
std::string canonical_json(const PolygonSet& canonical);

struct Canonical {
  PolygonSet region;
  std::size_t components = 0;
  std::size_t holes = 0;
  bool well_formed = true;  ///< false where the rings overlap (a winding number outside {0, 1})
};

/// The canonical form of the set of points with a positive winding number with respect to the rings
/// (outer rings counter-clockwise, holes clockwise; they may touch, overlap or cross). Exact.
Canonical canonicalize(const PolygonSet& rings);

}  // namespace minkref::inline plane
