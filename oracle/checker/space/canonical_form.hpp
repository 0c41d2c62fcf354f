// The canonical form of a set in space with a tiled boundary. docs/definitions.md
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "oracle/checker/space/convex_polygon.hpp"

namespace minkref::checker {

/// A normal, and the plane's height along the normal.
using OrientedPlane = std::pair<Whole, mpz_class>;
/// Convex polygons without overlaps, counter-clockwise seen against the normals.
using Tiles = std::map<OrientedPlane, std::vector<ConvexPolygon>>;

struct CanonicalForm {
  std::string text;  ///< the form of a convex polyhedron if the set is one
  mpq_class volume;
  std::size_t planes = 0, polygons = 0;
};

/// Coordinates are in units.
CanonicalForm canonical_form(const Tiles& tiles, const mpz_class& unit, Budget& budget);

}  // namespace minkref::checker
