#include "reference/space/surface/hidden_edges.hpp"

#include <algorithm>

#include "reference/space/surface/near_things.hpp"

namespace minkref::inline space {
namespace {

class CrossingSearch {
 public:
  explicit CrossingSearch(const LiftedRegions& regions)
      : regions_(regions), location_(regions), near_(regions.points) {
    for (const LiftedPolygon& polygon : regions.polygons) near_.add(polygon.rings[0]);
  }

  std::vector<std::pair<SpaceVertex, SpaceVertex>> run() {
    near_.pairs([&](std::uint32_t a, std::uint32_t b) {
      if (corners_of(a) > corners_of(b)) std::swap(a, b);
      if (straddles(a, b) && straddles(b, a)) look_along_crossing(a, b);
    });
    return std::move(found_);
  }

 private:
  std::size_t corners_of(std::uint32_t polygon) const {
    return regions_.polygons[polygon].rings[0].size();
  }

  /// Whether a polygon has corners on both sides of another polygon's plane. Common corners lie on
  /// the plane, and need no arithmetic.
  bool straddles(std::uint32_t polygon, std::uint32_t other) const {
    const FilteredPlane& plane = regions_.plane_of(other);
    bool above = false, below = false;
    for (const std::uint32_t corner : regions_.polygons[polygon].rings[0]) {
      if (near_.has_corner(other, corner)) continue;
      const int side = plane.side(regions_.points[corner]);
      above = above || side > 0;
      below = below || side < 0;
      if (above && below) return true;
    }
    return false;
  }

  void look_along_crossing(std::uint32_t a, std::uint32_t b) {
    std::vector<SpaceVertex> stops;
    add_stops(a, regions_.plane_of(b), stops);
    add_stops(b, regions_.plane_of(a), stops);
    const std::vector<SpaceVertex> along = shared_points(std::move(stops)).points;
    for (std::size_t k = 1; k < along.size(); ++k) {
      const SpacePoint &from = along[k - 1].exact, &to = along[k].exact;
      if (location_.locate(a, from, to) == Location::inside &&
          location_.locate(b, from, to) == Location::inside) {
        found_.emplace_back(along[k - 1], along[k]);
      }
    }
  }

  /// Adds the points where a polygon's border meets a plane.
  void add_stops(std::uint32_t polygon, const FilteredPlane& plane,
                 std::vector<SpaceVertex>& stops) const {
    for (const auto& ring : regions_.polygons[polygon].rings) {
      std::vector<int> sides;
      for (const std::uint32_t corner : ring) sides.push_back(plane.side(regions_.points[corner]));
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::size_t next = (k + 1) % ring.size();
        const SpaceVertex &p = regions_.points[ring[k]], &q = regions_.points[ring[next]];
        if (sides[k] == 0) stops.push_back(p);
        if (sides[k] * sides[next] < 0) stops.emplace_back(plane.crossing(p.exact, q.exact));
      }
    }
  }

  const LiftedRegions& regions_;
  PolygonLocation location_;
  NearThings near_;
  std::vector<std::pair<SpaceVertex, SpaceVertex>> found_;
};

}  // namespace

std::vector<std::pair<SpaceVertex, SpaceVertex>> hidden_edges(const LiftedRegions& regions) {
  return CrossingSearch(regions).run();
}

}  // namespace minkref::inline space
