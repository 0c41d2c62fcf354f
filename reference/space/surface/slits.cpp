#include "reference/space/surface/slits.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

class SlitSearch {
 public:
  SlitSearch(const LiftedRegions& regions, const ConformingEdges& edges)
      : regions_(regions), edges_(edges), location_(regions) {
    for (std::uint32_t r = 0; r < regions.planes.size(); ++r) {
      for (const auto& [from, to] : edges.borders[r]) {
        borders_.emplace_back(std::minmax(from, to), r);
      }
    }
    std::sort(borders_.begin(), borders_.end());
    std::vector<SpaceBox> boxes;
    for (const LiftedPolygon& polygon : regions_.polygons) boxes.push_back(polygon.box);
    tree_ = SpaceBoxTree(std::move(boxes));
  }

  std::vector<std::vector<PointPair>> slits() {
    std::vector<std::vector<PointPair>> result(regions_.planes.size());
    auto at = borders_.begin();
    for (const PointPair& segment : edges_.segments) {
      look_for_interrupt();
      const auto first = at;
      while (at != borders_.end() && at->first == segment) ++at;
      const SpaceVertex &u = edges_.points[segment.first], &v = edges_.points[segment.second];
      tree_.query(box_between(u, v), [&](std::uint32_t p) {
        const std::uint32_t r = regions_.polygons[p].region;
        const bool on_border = std::any_of(first, at, [&](const auto& use) {
          return use.second == r || is_reverse(use.second, r);
        });
        if (!on_border && lies_inside(p, u, v)) result[r].push_back(segment);
        return false;
      });
    }
    return result;
  }

  std::vector<std::vector<std::uint32_t>> tips() {
    const std::size_t planes = regions_.planes.size();
    std::vector<std::vector<std::uint32_t>> ends(planes), result(planes);
    for (std::size_t r = 0; r < planes; ++r) {
      for (const auto* list : {&edges_.borders[r], &edges_.slits[r]}) {
        for (const auto& [from, to] : *list) ends[r].push_back(from), ends[r].push_back(to);
      }
      std::sort(ends[r].begin(), ends[r].end());
    }
    for (std::uint32_t v = 0; v < edges_.points.size(); ++v) {
      look_for_interrupt();
      const SpaceVertex& point = edges_.points[v];
      tree_.query(box_between(point, point), [&](std::uint32_t p) {
        const std::uint32_t r = regions_.polygons[p].region;
        const bool is_end = std::binary_search(ends[r].begin(), ends[r].end(), v);
        if (!is_end && lies_inside(p, point, point)) result[r].push_back(v);
        return false;
      });
    }
    return result;
  }

 private:
  bool is_reverse(std::uint32_t a, std::uint32_t b) const {
    const OrientedPlane &p = regions_.planes[a].exact, &q = regions_.planes[b].exact;
    return p.normal == IntegerVector{} - q.normal && p.offset == -q.offset;
  }

  bool lies_inside(std::uint32_t polygon, const SpaceVertex& u, const SpaceVertex& v) {
    const FilteredPlane& plane = regions_.plane_of(polygon);
    if (plane.side(u) != 0 || plane.side(v) != 0) return false;
    const Location at = location_.locate(polygon, u.exact, v.exact);
    if (at == Location::boundary) {
      throw std::logic_error("an edge crosses the border of a plane region");
    }
    return at == Location::inside;
  }

  const LiftedRegions& regions_;
  const ConformingEdges& edges_;
  PolygonLocation location_;
  std::vector<std::pair<PointPair, std::uint32_t>> borders_;  ///< with their regions
  SpaceBoxTree tree_;
};

}  // namespace

void add_slits_and_tips(const LiftedRegions& regions, ConformingEdges& edges) {
  SlitSearch search(regions, edges);
  edges.slits = search.slits();
  edges.tips = search.tips();
}

}  // namespace minkref::inline space
