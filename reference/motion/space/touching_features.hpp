// The features of two operands that touch at a bound of the valid scales.
#pragma once

#include "reference/motion/space/solid_piece.hpp"
#include "reference/motion/space/valid_scales.hpp"

namespace minkref::inline space {

/// The vertex at a point, the edge through it, or the face that has it inside; none of a point off
/// the surface. Exact. Linear.
std::optional<SpaceFeature> feature_at(const Polyhedron& operand, const SpacePoint& point);

/// Points in which two convex pieces meet that share no volume: corners of one that are in the
/// other, and where their edges cross; by coordinates. Not empty where they meet. Exact.
std::vector<SpacePoint> touching_points(const SolidPiece& a, const SolidPiece& b);

}  // namespace minkref::inline space
