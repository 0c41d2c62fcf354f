// A convex cell of space that planes cut out of a box.
#pragma once

#include <vector>

#include "reference/space/definition/corner.hpp"

namespace minkref::inline space {

class ConvexCell {
 public:
  /// The least box around the points, which must have some extent along each axis.
  explicit ConvexCell(const std::vector<SpacePoint>& points);

  /// Keeps the part below the plane, which must not be empty. Exact. Linear.
  void cut(const CuttingPlane& plane);

  /// The surface with one face for each plane, counter-clockwise seen from outside.
  Polyhedron surface() const;

 private:
  struct Side {
    IntegerVector normal;
    CornerRing ring;
  };
  std::vector<Side> sides_;
};

}  // namespace minkref::inline space
