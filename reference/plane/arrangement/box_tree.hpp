// The bounding-volume hierarchy over boxes in the plane.
#pragma once

#include "reference/box_tree.hpp"
#include "reference/plane/kernel/box.hpp"

namespace minkref::inline plane {

using BoxTree = BasicBoxTree<Box>;

}  // namespace minkref::inline plane
