#include "reference/space/surface/slits.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "reference/interrupt.hpp"
#include "reference/space/surface/near_things.hpp"

namespace minkref::inline space {
namespace {

template <class List>
void sort_once(List& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

template <class List>
bool has(const List& sorted, const typename List::value_type& value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

class SlitSearch {
 public:
  SlitSearch(const LiftedRegions& regions, ConformingEdges& edges)
      : regions_(regions),
        edges_(edges),
        location_(regions),
        near_(edges.points),
        border_ends_(regions.planes.size()) {
    for (std::uint32_t r = 0; r < regions.planes.size(); ++r) {
      for (const auto& [from, to] : edges.borders[r]) {
        borders_.emplace_back(std::minmax(from, to), r);
        border_ends_[r].push_back(from);
        border_ends_[r].push_back(to);
      }
      sort_once(border_ends_[r]);
    }
    std::sort(borders_.begin(), borders_.end());
    for (const auto& [u, v] : edges.segments) near_.add({u, v});
    const std::vector<std::uint32_t> number = numbers_of_corners();
    for (const LiftedPolygon& polygon : regions.polygons) {
      std::vector<std::uint32_t> corners = polygon.rings[0];
      for (std::uint32_t& c : corners) c = number[c];
      near_.add(std::move(corners));
    }
  }

  void run() {
    const std::size_t planes = regions_.planes.size();
    edges_.slits.assign(planes, {});
    edges_.tips.assign(planes, {});
    const auto segments = static_cast<std::uint32_t>(edges_.segments.size());
    near_.pairs(
        [&](std::uint32_t s, std::uint32_t p) { look_inside(p - segments, edges_.segments[s]); },
        segments);
    for (auto& slits : edges_.slits) sort_once(slits);
    keep_tips();
  }

 private:
  /// The numbers of the regions' points among all points; both ascend.
  std::vector<std::uint32_t> numbers_of_corners() const {
    std::vector<std::uint32_t> number;
    std::uint32_t at = 0;
    for (const SpaceVertex& corner : regions_.points) {
      while (compare(edges_.points[at], corner) != 0) ++at;
      number.push_back(at);
    }
    return number;
  }

  /// Adds a segment inside to the slits, and ends on the plane to the possible tips: each point
  /// ends some segment.
  void look_inside(std::uint32_t polygon, const PointPair& segment) {
    const std::uint32_t r = regions_.polygons[polygon].region;
    const FilteredPlane& plane = regions_.plane_of(polygon);
    const std::array ends{segment.first, segment.second};
    std::size_t on_plane = 0;
    for (const std::uint32_t end : ends) {
      const bool on_border = has(border_ends_[r], end);
      if (!on_border && plane.side(edges_.points[end]) != 0) continue;
      ++on_plane;
      if (!on_border) touched_.emplace_back(polygon, end);
    }
    if (on_plane == 2 && !is_border(segment, r) && lies_inside(polygon, ends[0], ends[1])) {
      edges_.slits[r].push_back(segment);
    }
  }

  /// Whether a segment lies on the border of a region, or of the region on the plane's back.
  bool is_border(const PointPair& segment, std::uint32_t r) const {
    auto use = std::lower_bound(borders_.begin(), borders_.end(), std::pair(segment, 0U));
    for (; use != borders_.end() && use->first == segment; ++use) {
      if (use->second == r || is_reverse(use->second, r)) return true;
    }
    return false;
  }

  bool is_reverse(std::uint32_t a, std::uint32_t b) const {
    const OrientedPlane &p = regions_.planes[a].exact, &q = regions_.planes[b].exact;
    return p.normal == IntegerVector{} - q.normal && p.offset == -q.offset;
  }

  void keep_tips() {
    std::vector<std::vector<std::uint32_t>> slit_ends(edges_.slits.size());
    for (std::size_t r = 0; r < slit_ends.size(); ++r) {
      for (const auto& [u, v] : edges_.slits[r])
        slit_ends[r].push_back(u), slit_ends[r].push_back(v);
      sort_once(slit_ends[r]);
    }
    sort_once(touched_);
    for (const auto& [polygon, point] : touched_) {
      look_for_interrupt();
      const std::uint32_t r = regions_.polygons[polygon].region;
      if (has(slit_ends[r], point) || !lies_inside(polygon, point, point)) continue;
      edges_.tips[r].push_back(point);
    }
    for (auto& tips : edges_.tips) sort_once(tips);
  }

  /// For a segment, or a point, within the polygon's plane.
  bool lies_inside(std::uint32_t polygon, std::uint32_t u, std::uint32_t v) {
    const Location at = location_.locate(polygon, edges_.points[u].exact, edges_.points[v].exact);
    if (at == Location::boundary) {
      throw std::logic_error("an edge crosses the border of a plane region");
    }
    return at == Location::inside;
  }

  const LiftedRegions& regions_;
  ConformingEdges& edges_;
  PolygonLocation location_;
  NearThings near_;
  std::vector<std::vector<std::uint32_t>> border_ends_;           ///< by region, ascending
  std::vector<std::pair<PointPair, std::uint32_t>> borders_;      ///< with their regions, ascending
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touched_;  ///< polygons, points in planes
};

}  // namespace

void add_slits_and_tips(const LiftedRegions& regions, ConformingEdges& edges) {
  SlitSearch(regions, edges).run();
}

}  // namespace minkref::inline space
