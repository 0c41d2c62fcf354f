// The outside of a container as an obstacle.
#pragma once

#include "reference/motion/valid_scales.hpp"
#include "reference/plane/erosion/outside.hpp"

namespace minkref::inline motion {

/// A box less a container, so wide that a part which does not meet the set lies inside the
/// container or all outside the box.
struct ContainerFrame {
  ScaleWindow window;  ///< up to twice the greatest scale at which the part's box fits
  Outside outside;

  /// For a part at scales at which its box fits into the container's box. `about`: places of the
  /// part for later questions; there the part is not outside the box. Exact. Throws BadInput
  /// ("point-part") for a part without any extent.
  ContainerFrame(const PolygonSet& part, const PolygonSet& container,
                 const std::vector<Point>& about);

  /// The obstacle.
  const PolygonSet& set() const { return outside.set; }
  /// The same feature in the container's rings.
  TouchingFeature in_container(const TouchingFeature& feature) const;
};

}  // namespace minkref::inline motion
