#include "reference/space/definition/convex_cell.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace minkref::inline space {

ConvexCell::ConvexCell(const std::vector<SpacePoint>& points) {
  SpacePoint low = points.at(0), high = low;
  for (const SpacePoint& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      Side side{{0, 0, 0}, {}};
      side.normal[axis] = upper ? 1 : -1;
      for (const auto& [first, second] : {std::pair(false, false), std::pair(true, false),
                                          std::pair(true, true), std::pair(false, true)}) {
        const bool x = axis == 0 ? upper : first;
        const bool y = axis == 1 ? upper : axis == 0 ? first : second;
        const bool z = axis == 2 ? upper : second;
        side.ring.push_back(
            solid_corner(SpacePoint{x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z}));
      }
      sides_.push_back(std::move(side));
    }
  }
}

void ConvexCell::cut(const CuttingPlane& plane) {
  std::vector<SolidCorner> on_plane;
  std::vector<Side> kept;
  bool cuts = false;
  for (Side& side : sides_) {
    const RingSides found = sides_of(side.ring, plane);
    cuts = cuts || found.above;
    for (std::size_t k = 0; k < side.ring.size(); ++k) {
      if (found.sides[k] == 0) on_plane.push_back(side.ring[k]);
    }
    if (!found.above) {
      kept.push_back(std::move(side));
    } else if (found.below) {
      CornerRing below = halves(side.ring, found, plane).below;
      for (std::size_t k = 0; k < below.size(); ++k) {
        if (plane.side(below[k]) == 0) on_plane.push_back(below[k]);
      }
      kept.push_back({side.normal, std::move(below)});
    }
  }
  sides_ = std::move(kept);
  if (!cuts) return;
  const IntegerVector& normal = plane.plane().normal;
  CornerRing lid = convex_ring(std::move(on_plane), viewing_axis(normal));
  if (lid.size() >= 3) sides_.push_back({normal, std::move(lid)});
}

Polyhedron ConvexCell::surface() const {
  const auto less = [](const SpacePoint& a, const SpacePoint& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<SpacePoint, std::uint32_t, decltype(less)> numbers(less);
  Polyhedron result;
  for (const Side& side : sides_) {
    Face face;
    for (const SolidCorner& corner : convex_ring_about(side.ring, side.normal)) {
      const auto [at, fresh] = numbers.try_emplace(
          exact_point(corner), static_cast<std::uint32_t>(result.vertices.size()));
      if (fresh) result.vertices.push_back(at->first);
      face.push_back(at->second);
    }
    result.faces.push_back(std::move(face));
  }
  return result;
}

}  // namespace minkref::inline space
