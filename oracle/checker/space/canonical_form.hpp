// The canonical form of a set in space whose boundary is tiled. docs/definitions.md
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "oracle/checker/space/convex_polygon.hpp"

namespace minkref::checker {

/// A normal, and its product with the points.
using OrientedPlane = std::pair<Whole, mpz_class>;
/// Convex polygons that do not overlap, counter-clockwise seen against the normals.
using Tiles = std::map<OrientedPlane, std::vector<ConvexPolygon>>;

struct CanonicalForm {
  std::string text;  ///< that of a convex polyhedron where it is one
  mpq_class volume;
  std::size_t planes = 0, polygons = 0;
};

/// Coordinates are in units.
CanonicalForm canonical_form(const Tiles& tiles, const mpz_class& unit, Budget& budget);

}  // namespace minkref::checker
