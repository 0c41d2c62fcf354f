// Plane regions with their corners in space.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/location.hpp"
#include "reference/space/surface/space_vertex.hpp"

namespace minkref::inline space {

/// A polygon of a region.
struct LiftedPolygon {
  std::uint32_t region;
  const Polygon* polygon;                         ///< as it is seen
  std::vector<std::vector<std::uint32_t>> rings;  ///< numbers of points, the outer ring first
  SpaceBox box;
};

/// The regions of a set that lives longer.
struct LiftedRegions {
  std::vector<SpaceVertex> points;  ///< distinct, ascending
  std::vector<FilteredPlane> planes;
  std::vector<LiftedPolygon> polygons;

  explicit LiftedRegions(const PolyhedralSet& set);
  const FilteredPlane& plane_of(std::uint32_t polygon) const {
    return planes[polygons[polygon].region];
  }
};

/// Tells what lies inside of polygons, each of them asked many times.
class PolygonLocation {
 public:
  explicit PolygonLocation(const LiftedRegions& regions)
      : regions_(regions), rings_(regions.polygons.size()) {}

  /// Locates the middle of a segment in the plane of the polygon. Exact; linear.
  Location locate(std::uint32_t polygon, const SpacePoint& from, const SpacePoint& to);

 private:
  const LiftedRegions& regions_;
  std::vector<std::vector<FilteredRing>> rings_;  ///< made when they are first needed
};

}  // namespace minkref::inline space
