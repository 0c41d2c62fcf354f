// A container's outside as an obstacle.
#pragma once

#include <vector>

#include "reference/motion/space/valid_scales.hpp"

namespace minkref::inline space {

struct ExactSpaceBox {
  SpacePoint low, high;
  explicit ExactSpaceBox(const std::vector<SpacePoint>& points);
  void add(const SpacePoint& p);
};

/// A box less a container, so wide that a part which does not meet it lies inside the container, or
/// all outside the box.
struct SpaceFrame {
  Polyhedron set;      ///< the container's vertices and faces first, these turned over
  ScaleWindow window;  ///< up to twice the greatest scale at which the part's box fits

  /// `about`: places of the part for later questions; there the part is not outside the box. Exact.
  /// Throws as `refuse_bad_fit`.
  SpaceFrame(const Polyhedron& part, const Polyhedron& container,
             const std::vector<SpacePoint>& about);
};

/// Throws BadInput: "degenerate-operands" if the container has no volume, "point-part" if the part
/// is a point, or empty.
void refuse_bad_fit(const Polyhedron& part, const Polyhedron& container);

}  // namespace minkref::inline space
