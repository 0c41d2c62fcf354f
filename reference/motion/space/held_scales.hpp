// Scales where an assembly holds a polyhedron (Behar & Lien 2012, Section 8.1).
#pragma once

#include "reference/motion/held_scales.hpp"
#include "reference/motion/space/valid_scales.hpp"

namespace minkref::inline space {

using SpaceHeldScales = HeldScalesOf<SpacePathBound>;

/// As for the plane. Exact. Throws and costs as `valid_scales` in space.
SpaceHeldScales held_scales(const Polyhedron& part, const Polyhedron& obstacles,
                            const std::vector<SpacePoint>& way,
                            ContactRule rule = ContactRule::allowed, const ScaleWindow& window = {},
                            PathRoute route = PathRoute::pieces);

}  // namespace minkref::inline space
