// Convex polygons in space, cut by half-spaces.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/checker/space/space.hpp"

namespace minkref::checker {

/// The point (x / w, y / w, z / w), w > 0.
using Corner = std::array<mpz_class, 4>;
using ConvexPolygon = std::vector<Corner>;
/// normal * x <= height
using HalfSpace = std::pair<Whole, mpz_class>;

/// Returns the part below a plane of a convex polygon with an area: empty if the part has no area,
/// null if the plane cuts nothing off, as for a polygon in the plane.
std::optional<ConvexPolygon> below(const ConvexPolygon& polygon, const HalfSpace& half,
                                   Budget& budget);

}  // namespace minkref::checker
