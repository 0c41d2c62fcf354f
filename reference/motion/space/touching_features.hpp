// The features of two operands that touch at a bound of the valid scales.
#pragma once

#include "reference/motion/space/solid_piece.hpp"
#include "reference/motion/space/valid_scales.hpp"

namespace minkref::inline space {

/// The vertex at a point, the edge through it, or the face around it; none for a point off the
/// surface. Exact. Linear.
std::optional<SpaceFeature> feature_at(const Polyhedron& operand, const SpacePoint& point);

/// The common points of two convex pieces without a common volume: corners of either inside the
/// other, and crossings of edges; sorted by coordinates. Not empty if the pieces meet. Exact.
std::vector<SpacePoint> touching_points(const SolidPiece& a, const SolidPiece& b);

}  // namespace minkref::inline space
