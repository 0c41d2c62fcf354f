// Owners beside a segment as robot: from edges of merged obstacles back to edges of copies.
#pragma once

#include <vector>

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_boundary.hpp"

namespace minkref::inline scene {

/// Merged obstacles: `region` unites placed copies; `sides` has owners of its sides
/// beside a robot without extent.
struct ObstacleOwners {
  const PolygonSet& region;
  const std::vector<RingOwners>& sides;
  const std::vector<PolygonSet>& shapes;
  std::vector<Copy> copies;
  std::vector<std::uint32_t> first_ring;  ///< of each polygon of the region
};
ObstacleOwners obstacle_owners(const PolygonSet& region, const std::vector<RingOwners>& sides,
                               const std::vector<PolygonSet>& shapes, std::vector<Copy> copies);

/// Appends what a contact with an obstacle, a polygon of the region, means for the copies. A vertex
/// of an obstacle may be a crossing of copies: then the vertices count at which the crossing edges
/// begin.
void add_owners(const ObstacleOwners& obstacles, std::uint32_t obstacle,
                const ConvolutionEdge& contact, std::vector<Owner>& owners);

}  // namespace minkref::inline scene
