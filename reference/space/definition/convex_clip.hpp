// Cuts a polygon by a convex piece's planes.
#pragma once

#include <vector>

#include "reference/space/definition/exact_vectors.hpp"

namespace minkref::inline space {

/// The points x below a plane: normal · x <= offset.
struct HalfSpace {
  SpacePoint normal;
  Rational offset;
};

/// The part of a convex polygon (or segment, or point) below all planes; perhaps empty. Exact. O(n
/// (n + k)) for n planes and k corners.
std::vector<SpacePoint> below_all(std::vector<SpacePoint> ring,
                                  const std::vector<HalfSpace>& planes);

/// Whether some point of the ring lies strictly below all planes. Exact.
bool is_strictly_below_somewhere(const std::vector<SpacePoint>& ring,
                                 const std::vector<HalfSpace>& planes);

}  // namespace minkref::inline space
