#include "reference/disc/diagram/diagram_count.hpp"

#include <algorithm>
#include <map>

namespace minkref::inline disc {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// The vertices on the boundary of the convex hull, counter-clockwise.
std::vector<std::uint32_t> on_hull(const OffsetCurves& curves) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t k = 0; k < curves.features.size(); ++k) {
    if (curves.features[k].edge == OffsetPatch::none) all.push_back(k);
  }
  const auto at = [&](std::uint32_t k) -> const Point& { return curves.features[k].centre; };
  std::sort(all.begin(), all.end(), [&](std::uint32_t a, std::uint32_t b) {
    return at(a).x != at(b).x ? at(a).x < at(b).x : at(a).y < at(b).y;
  });
  std::vector<std::uint32_t> hull;
  const auto chain = [&](auto first, auto last) {
    const std::size_t before = hull.size();
    for (; first != last; ++first) {
      while (hull.size() > before + 1 && cross(from_to(at(hull[hull.size() - 2]), at(hull.back())),
                                               from_to(at(hull.back()), at(*first))) < 0) {
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();
  };
  chain(all.begin(), all.end());
  chain(all.rbegin(), all.rend());
  return hull;
}

}  // namespace

DiagramCount diagram_count(const OffsetCurves& curves, const BoundaryWalks& walks) {
  DiagramCount count;
  if (walks.sides.empty()) return count;
  std::int64_t reflex = 0, characteristic = 0;
  for (const BoundaryWalk& walk : walks.walks) characteristic += walk.is_outer ? 1 : -1;
  Pairs edges;
  for (const BoundarySide& side : walks.sides) {
    reflex += side.ends_at_reflex ? 1 : 0;
    if (!side.is_arc) {
      edges.insert({side.from, side.to});
      continue;
    }
    count.joints.insert({curves.edges[side.edge].feature, side.feature});
    count.joints.insert({curves.edges[side.next].feature, side.feature});
  }
  const std::vector<std::uint32_t> hull = on_hull(curves);
  std::map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> beside;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const std::uint32_t next = hull[(k + 1) % hull.size()];
    if (!edges.contains({hull[k], next})) count.gaps.push_back({hull[k], next});
    beside[hull[k]].second = next;
    beside[next].first = hull[k];
  }
  // Drops rays that never leave the region nearest to the end.
  std::erase_if(count.joints, [&](const auto& joint) {
    const auto found = beside.find(joint.second);
    if (found == beside.end()) return false;
    const Direction& normal = curves.edges[curves.features[joint.first].edge].normal;
    const Point& end = curves.features[joint.second].centre;
    const auto is_behind = [&](std::uint32_t other) {
      return dot(normal, from_to(end, curves.features[other].centre)) <= 0;
    };
    return is_behind(found->second.first) && is_behind(found->second.second);
  });
  count.excess = reflex + 2 * characteristic - 2 - static_cast<std::int64_t>(count.gaps.size());
  return count;
}

}  // namespace minkref::inline disc
