// Moving boxes in space.
#pragma once

#include "reference/moving_box.hpp"
#include "reference/space/box_tree.hpp"

namespace minkref::inline space {

using MovingBox = BasicMovingBox<SpaceBox>;
using MovingBoxTree = BasicBoxTree<MovingBox>;

}  // namespace minkref::inline space
