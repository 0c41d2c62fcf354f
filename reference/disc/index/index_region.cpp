#include "reference/disc/index/index_region.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {

std::uint32_t IndexRegions::polygon_of(std::uint32_t side) const {
  return curves_.edges[index_.diagram().walks.sides[side].edge].polygon;
}

/// The ring with a component's leftmost point.
std::uint32_t IndexRegions::outer_ring(std::uint32_t polygon, const IndexBoundary& boundary) const {
  const DiagramGraph::Leftmost& leftmost = index_.graph().leftmost[polygon];
  // The last corner before the leftmost vertex along the same walk, at which a part of the boundary
  // starts.
  const IndexCorner *before = nullptr, *last = nullptr;
  for (const IndexCorner& corner : boundary.corners) {
    if (corner.walk != leftmost.walk) continue;
    if (last == nullptr || last->half < corner.half) last = &corner;
    if (corner.half > leftmost.half || leftmost.half == DiagramGraph::none) continue;
    if (before == nullptr || before->half < corner.half) before = &corner;
  }
  if (before == nullptr) before = last;
  for (std::uint32_t k = 0; k < boundary.rings.size(); ++k) {
    const IndexRing& ring = boundary.rings[k];
    if (before == nullptr && ring.first_corner == ring.last_corner && ring.walk == leftmost.walk) {
      return k;
    }
    if (before == nullptr) continue;
    const auto number = static_cast<std::uint32_t>(before - boundary.corners.data());
    if (ring.first_corner <= number && number < ring.last_corner) return k;
  }
  throw std::logic_error("a component of an offset has no outer ring");
}

IndexRegion IndexRegions::at(std::uint32_t gap) const {
  const FloatEnvironment standard;
  if (curves_.edges.empty()) {  // a point, or nothing
    IndexRegion region{{}, 0};
    if (!curves_.patches.empty()) region.form.push_back({{{curves_.patches[0].feature}, 0}, {}});
    return region;
  }
  IndexBoundary boundary;
  index_.boundary(gap, boundary);
  DisjointSets sets(history_.polygons);
  for (const ComponentJoin& join : history_.joins) {
    if (join.radius <= gap) sets.join(join.a, join.b);
  }
  // Each component's leftmost vertex.
  std::map<std::uint32_t, std::uint32_t> leftmost;  // polygons, by root
  const auto& features = index_.diagram().curves.features;
  for (std::uint32_t k = 0; k < history_.polygons; ++k) {
    const auto [found, is_new] = leftmost.try_emplace(sets.root(k), k);
    const Point &a = features[index_.graph().leftmost[k].vertex].centre,
                &b = features[index_.graph().leftmost[found->second].vertex].centre;
    if (!is_new && (a.x < b.x || (a.x == b.x && a.y < b.y))) found->second = k;
  }
  std::map<std::uint32_t, FormComponent> of_root;
  std::vector<char> is_outer(boundary.rings.size(), 0);
  for (const auto& [root, polygon] : leftmost) {
    const std::uint32_t ring = outer_ring(polygon, boundary);
    is_outer[ring] = 1;
    of_root[root].outer = {curves_of(boundary, boundary.rings[ring]), ring};
  }
  for (std::uint32_t k = 0; k < boundary.rings.size(); ++k) {
    if (is_outer[k] != 0) continue;
    const IndexRing& ring = boundary.rings[k];
    const BoundaryWalk& walk = index_.diagram().walks.walks[ring.walk];
    of_root.at(sets.root(polygon_of(walk.first))).holes.push_back({curves_of(boundary, ring), k});
  }
  IndexRegion region{{}, boundary.rings.size() - of_root.size()};
  for (auto& [root, component] : of_root) region.form.push_back(std::move(component));
  make_canonical(region.form, curves_);
  return region;
}

/// A ring's curves: consecutive sides on one line form one curve.
std::vector<std::uint32_t> IndexRegions::curves_of(const IndexBoundary& boundary,
                                                   const IndexRing& ring) const {
  const BoundaryWalks& walks = index_.diagram().walks;
  std::vector<std::uint32_t> found;
  const auto add = [&](const BoundaryWalk& walk, std::uint32_t side, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t feature = walks.sides[side].feature;
      if (k == 0 || found.back() != feature) found.push_back(feature);
      side = side + 1 == walk.last ? walk.first : side + 1;
    }
  };
  if (ring.first_corner == ring.last_corner) {
    const BoundaryWalk& walk = walks.walks[ring.walk];
    add(walk, walk.first, walk.last - walk.first);
    while (found.size() > 1 && found.front() == found.back()) found.pop_back();
  }
  for (std::uint32_t k = ring.first_corner; k < ring.last_corner; ++k) {
    const IndexCorner& corner = boundary.corners[k];
    add(walks.walks[corner.walk], corner.first_side, corner.sides);
  }
  return found;
}

}  // namespace minkref::inline disc
