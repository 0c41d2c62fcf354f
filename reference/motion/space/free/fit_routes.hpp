// The two ways to the scales at which a part fits somewhere in a container.
#pragma once

#include "reference/motion/space/free/fits_and_traps.hpp"

namespace minkref::inline space {

/// For a part with an extent, and a convex container.
SpaceFreeScales fit_into_convex(const Polyhedron& part, const Polyhedron& container,
                                ContactRule rule);

}  // namespace minkref::inline space
