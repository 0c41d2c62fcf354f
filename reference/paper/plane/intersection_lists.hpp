// The intersections along each edge, in their order (Behar & Lien 2012, Sec. 4.2.4).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "reference/paper/plane/critical_regions.hpp"

namespace minkref::inline plane {

/// Each edge's intersecting regions. With Order::kept each region is inserted at its place at the
/// scale of its event, and stays there; otherwise the order means nothing.
template <class T>
class IntersectionLists {
 public:
  IntersectionLists(const std::vector<MovingEdge<Vector2<T>>>& edges,
                    const std::vector<CriticalRegion<T>>& regions, Readings::Order order)
      : edges_(edges), regions_(regions), order_(order), lists_(edges.size()) {}

  void insert(std::uint32_t region, const T& scale) {
    for (const std::uint32_t edge : {regions_[region].a, regions_[region].b}) {
      auto& list = lists_[edge];
      if (order_ == Readings::Order::sorted || regions_[region].parallel) {
        list.push_back(region);
        continue;
      }
      const T here = place(edge, region, scale);
      const auto at = std::upper_bound(
          list.begin(), list.end(), region, [&](std::uint32_t, std::uint32_t other) {
            return !regions_[other].parallel && sign(T(here - place(edge, other, scale))) < 0;
          });
      list.insert(at, region);
    }
  }

  void erase(std::uint32_t region) {
    for (const std::uint32_t edge : {regions_[region].a, regions_[region].b}) {
      auto& list = lists_[edge];
      list.erase(std::find(list.begin(), list.end(), region));
    }
  }

  const std::vector<std::uint32_t>& along(std::uint32_t edge) const { return lists_[edge]; }

  /// An intersection's distance from an edge's start, along the edge's direction.
  T place(std::uint32_t edge, std::uint32_t region, const T& scale) const {
    const MovingEdge<Vector2<T>>& e = edges_[edge];
    return T(e.d.dot(Vector2<T>(regions_[region].x.at(scale) - at(start_of(e), scale))));
  }

 private:
  const std::vector<MovingEdge<Vector2<T>>>& edges_;
  const std::vector<CriticalRegion<T>>& regions_;
  Readings::Order order_;
  std::vector<std::vector<std::uint32_t>> lists_;
};

}  // namespace minkref::inline plane
