// A set's boundary in space, seen along the axes.
#pragma once

#include <array>

#include "reference/space/polyhedral_set.hpp"

namespace minkref::inline space {

/// The areas of the projections of all faces along x, y and z, added up: what is behind something
/// else counts as well, and every face once for each axis. Exact. Linear.
std::array<Rational, 3> projected_areas(const PolyhedralSet& set);

}  // namespace minkref::inline space
