// Plane regions with their corners in space.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/location.hpp"
#include "reference/space/surface/space_vertex.hpp"

namespace minkref::inline space {

/// One region's polygon.
struct LiftedPolygon {
  std::uint32_t region;
  const Polygon* polygon;                         ///< as it is seen
  std::vector<std::vector<std::uint32_t>> rings;  ///< numbers of points, the outer ring first
  SpaceBox box;
};

/// A set's regions; the set must live longer.
struct LiftedRegions {
  std::vector<SpaceVertex> points;  ///< distinct, ascending
  std::vector<FilteredPlane> planes;
  std::vector<LiftedPolygon> polygons;

  explicit LiftedRegions(const PolyhedralSet& set);
  const FilteredPlane& plane_of(std::uint32_t polygon) const {
    return planes[polygons[polygon].region];
  }
};

/// Tells what lies inside polygons, with many questions to each polygon.
class PolygonLocation {
 public:
  explicit PolygonLocation(const LiftedRegions& regions)
      : regions_(regions), rings_(regions.polygons.size()) {}

  /// Locates a segment's middle within the polygon's plane. Exact; linear.
  Location locate(std::uint32_t polygon, const SpacePoint& from, const SpacePoint& to);

 private:
  const LiftedRegions& regions_;
  std::vector<std::vector<FilteredRing>> rings_;  ///< made when they are first needed
};

}  // namespace minkref::inline space
