// The outside of a container as an obstacle.
#pragma once

#include "reference/motion/valid_scales.hpp"

namespace minkref::inline motion {

/// A box less a container, so wide that a part which does not meet the set lies inside the
/// container or all outside the box.
struct ContainerFrame {
  PolygonSet set;
  ScaleWindow window;  ///< up to twice the greatest scale at which the part's box fits

  /// For a part at scales at which its box fits into the container's box. `about`: places of the
  /// part for later questions; there the part is not outside the box. Exact. Throws BadInput
  /// ("point-part") for a part without any extent.
  ContainerFrame(const PolygonSet& part, const PolygonSet& container,
                 const std::vector<Point>& about);

  /// The same feature in the container's rings.
  TouchingFeature in_container(const TouchingFeature& feature) const;

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rings_;  ///< of the container, and lengths
};

}  // namespace minkref::inline motion
