#include "reference/space/surface/lifted_regions.hpp"

#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline space {

LiftedRegions::LiftedRegions(const PolyhedralSet& set) {
  std::vector<SpaceVertex> corners;
  for (std::uint32_t r = 0; r < set.faces.size(); ++r) {
    const PlaneRegion& face = set.faces[r];
    planes.emplace_back(face.plane);
    for (const Polygon& polygon : face.region.polygons) {
      LiftedPolygon& lifted_one = polygons.emplace_back();
      lifted_one.region = r;
      lifted_one.polygon = &polygon;
      const auto add = [&](const Ring& ring) {
        auto& numbers = lifted_one.rings.emplace_back();
        for (const Point& point : ring) {
          look_for_interrupt();
          numbers.push_back(static_cast<std::uint32_t>(corners.size()));
          const SpaceVertex& corner = corners.emplace_back(lifted(point, face.plane));
          lifted_one.box.add(box_between(corner, corner));
        }
      };
      add(polygon.outer);
      for (const Ring& hole : polygon.holes) add(hole);
    }
  }
  SharedPoints shared = shared_points(std::move(corners));
  points = std::move(shared.points);
  for (LiftedPolygon& polygon : polygons) {
    for (auto& ring : polygon.rings) {
      for (std::uint32_t& point : ring) point = shared.number[point];
    }
  }
}

Location PolygonLocation::locate(std::uint32_t polygon, const SpacePoint& from,
                                 const SpacePoint& to) {
  const Polygon& rings = *regions_.polygons[polygon].polygon;
  std::vector<FilteredRing>& filtered = rings_[polygon];
  if (filtered.empty()) {
    filtered.push_back(filtered_ring(rings.outer));
    for (const Ring& hole : rings.holes) filtered.push_back(filtered_ring(hole));
  }
  const std::size_t axis = viewing_axis(regions_.plane_of(polygon).exact.normal);
  const Point a = seen(from, axis), b = seen(to, axis);
  const FilteredPoint middle({(a.x + b.x) / 2, (a.y + b.y) / 2});
  for (std::size_t k = 0; k < filtered.size(); ++k) {
    const Location at = plane::locate(filtered[k], middle);
    if (at == Location::boundary) return at;
    if ((at == Location::inside) != (k == 0)) return Location::outside;
  }
  return Location::inside;
}

}  // namespace minkref::inline space
