#include "reference/space/definition/convex_clip.hpp"

#include <algorithm>
#include <utility>

namespace minkref::inline space {

std::vector<SpacePoint> below_all(std::vector<SpacePoint> ring,
                                  const std::vector<HalfSpace>& planes) {
  std::vector<Rational> heights;
  for (const HalfSpace& plane : planes) {
    heights.clear();
    bool some_above = false;
    for (const SpacePoint& p : ring) {
      heights.push_back(dot(plane.normal, p) - plane.offset);
      some_above = some_above || heights.back() > 0;
    }
    if (!some_above) continue;
    std::vector<SpacePoint> rest;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = (i + 1) % ring.size();
      if (heights[i] <= 0) rest.push_back(ring[i]);
      if (sign(heights[i]) * sign(heights[j]) < 0) {
        const Rational part = heights[i] / (heights[i] - heights[j]);
        rest.push_back(ring[i] + part * (ring[j] - ring[i]));
      }
    }
    ring = std::move(rest);
    if (ring.empty()) break;
  }
  return ring;
}

bool is_strictly_below_somewhere(const std::vector<SpacePoint>& ring,
                                 const std::vector<HalfSpace>& planes) {
  const std::vector<SpacePoint> rest = below_all(ring, planes);
  // A corner strictly below for each plane: then so is the middle of all corners.
  return !rest.empty() && std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
    return std::any_of(rest.begin(), rest.end(),
                       [&](const SpacePoint& p) { return dot(plane.normal, p) < plane.offset; });
  });
}

}  // namespace minkref::inline space
