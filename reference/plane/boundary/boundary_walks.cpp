// Closed walks along a boundary, each walk's component of the interior, and the set's holes.
#include <algorithm>
#include <functional>
#include <numeric>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/left_rays.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

class WalkFinder {
 public:
  explicit WalkFinder(const FilteredBoundary& graph) : graph_(graph), left_rays_(edges(graph)) {
    order_rays();
  }

  Walks find() {
    Walks result;
    const Cycles interior = cycles(true);
    std::vector<std::uint32_t>& walk_of = result.walk_of;
    walk_of.resize(graph_.edges.size());
    for (std::uint32_t w = 0; w < interior.first.size(); ++w) {
      Walk& walk = result.walks.emplace_back();
      std::uint32_t e = interior.first[w];
      do {
        walk.points.push_back(graph_.edges[e].first);
        walk_of[e] = w;
        e = interior.next[e];
      } while (e != interior.first[w]);
      walk.encloses = !opens_to_the_left(interior, w, true);
    }
    assign_components(result, interior);
    const Cycles exterior = cycles(false);
    for (std::uint32_t w = 0; w < exterior.first.size(); ++w) {
      result.holes += !opens_to_the_left(exterior, w, false);
    }
    return result;
  }

 private:
  /// An edge seen from either end.
  struct Ray {
    std::uint32_t edge;
    bool leaving;
  };
  struct Cycles {
    std::vector<std::uint32_t> next;   ///< edge after each edge
    std::vector<std::uint32_t> first;  ///< an edge of each cycle
    std::vector<std::uint32_t> least;  ///< its lexicographically least point
  };

  static std::vector<LeftRays::Edge> edges(const FilteredBoundary& graph) {
    std::vector<LeftRays::Edge> result;
    result.reserve(graph.edges.size());
    for (const auto& [from, to] : graph.edges) {
      result.push_back({graph.points[from], graph.points[to]});
    }
    return result;
  }
  const FilteredPoint& far_end(const Ray& ray) const {
    const auto& edge = graph_.edges[ray.edge];
    return point(ray.leaving ? edge.second : edge.first);
  }
  const FilteredPoint& point(std::uint32_t p) const { return *graph_.points[p]; }

  /// Rays around each point, counter-clockwise from the angle of -180 degrees.
  void order_rays() {
    first_ray_.assign(graph_.points.size() + 1, 0);
    for (const auto& [from, to] : graph_.edges) ++first_ray_[from + 1], ++first_ray_[to + 1];
    std::partial_sum(first_ray_.begin(), first_ray_.end(), first_ray_.begin());
    rays_.resize(2 * graph_.edges.size());
    std::vector<std::uint32_t> place(first_ray_.begin(), first_ray_.end());
    for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
      rays_[place[graph_.edges[e].first]++] = {e, true};
      rays_[place[graph_.edges[e].second]++] = {e, false};
    }
    for (std::uint32_t p = 0; p < graph_.points.size(); ++p) {
      look_for_interrupt();
      const FilteredPoint& at = point(p);
      const auto half = [&](const Ray& ray) {
        const int y = compare_y(far_end(ray), at);
        return y < 0 || (y == 0 && compare_x(far_end(ray), at) < 0) ? 0 : 1;
      };
      const auto before = [&](const Ray& a, const Ray& b) {
        const int ha = half(a), hb = half(b);
        if (ha != hb) return ha < hb;
        const int turn = orientation(at, far_end(a), far_end(b));
        return turn != 0 ? turn > 0 : !a.leaving && b.leaving;  // of a slit
      };
      Ray *const begin = rays_.data() + first_ray_[p], *const end =
                                                           rays_.data() + first_ray_[p + 1];
      if (end - begin != 2) {
        std::stable_sort(begin, end, before);
      } else if (before(begin[1], begin[0])) {
        std::swap(begin[0], begin[1]);
      }
    }
  }

  /// Pairs each arriving edge with the leaving one across a wedge of the interior (the next ray
  /// clockwise) or of the exterior (the next ray counter-clockwise).
  Cycles cycles(bool interior) const {
    Cycles result;
    result.next.assign(graph_.edges.size(), no_entry);
    for (std::uint32_t p = 0; p < graph_.points.size(); ++p) {
      const std::uint32_t begin = first_ray_[p], count = first_ray_[p + 1] - begin;
      for (std::uint32_t i = 0; i < count; ++i) {
        if (rays_[begin + i].leaving) continue;
        for (std::uint32_t step = 1; step < count; ++step) {
          const std::uint32_t j = interior ? (i + count - step) % count : (i + step) % count;
          if (!rays_[begin + j].leaving) continue;
          result.next[rays_[begin + i].edge] = rays_[begin + j].edge;
          break;
        }
      }
    }
    std::vector<bool> seen(graph_.edges.size(), false);
    for (std::uint32_t first = 0; first < graph_.edges.size(); ++first) {
      if (seen[first]) continue;
      std::uint32_t least = graph_.edges[first].first, e = first;
      while (!seen[e]) {
        look_for_interrupt();
        seen[e] = true;
        const std::uint32_t p = graph_.edges[e].first;
        if (p != least && compare_xy(point(p), point(least)) < 0) least = p;
        e = result.next[e];
      }
      result.first.push_back(first);
      result.least.push_back(least);
    }
    return result;
  }

  /// Whether some wedge of the cycle at its least point contains the direction to the left: the
  /// region that the cycle bounds then lies outside the cycle.
  bool opens_to_the_left(const Cycles& cycles, std::uint32_t cycle, bool interior) const {
    const std::uint32_t p = cycles.least[cycle];
    const std::uint32_t begin = first_ray_[p], count = first_ray_[p + 1] - begin;
    std::uint32_t e = cycles.first[cycle];
    do {
      const std::uint32_t out = cycles.next[e];
      if (graph_.edges[out].first == p) {
        std::uint32_t i_in = 0, i_out = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
          if (rays_[begin + i].edge == e && !rays_[begin + i].leaving) i_in = i;
          if (rays_[begin + i].edge == out && rays_[begin + i].leaving) i_out = i;
        }
        // The wedge runs counter-clockwise from `out` to `in` (interior) or from `in` to `out`; at
        // the least point every ray of the cycle points to the right, so the wedge holds the left
        // iff its first ray comes last by angle.
        if (interior ? i_out > i_in : i_in > i_out) return true;
      }
      e = out;
    } while (e != cycles.first[cycle]);
    return false;
  }

  void assign_components(Walks& result, const Cycles& interior) {
    std::vector<std::uint32_t> order(result.walks.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return compare_xy(point(interior.least[a]), point(interior.least[b])) < 0;
    });
    for (const std::uint32_t w : order) {
      Walk& walk = result.walks[w];
      if (walk.encloses) {
        walk.component = static_cast<std::uint32_t>(result.components++);
        continue;
      }
      const std::uint32_t edge = nearest_to_the_left(interior.least[w]);
      walk.component = edge == no_entry ? 0 : result.walks[result.walk_of[edge]].component;
    }
  }

  /// The component lies right of a downward edge.
  std::uint32_t nearest_to_the_left(std::uint32_t p) {
    const auto runs_down = [&](std::uint32_t e) {
      return compare_y(point(graph_.edges[e].second), point(graph_.edges[e].first)) < 0;
    };
    return left_rays_.first(point(p), runs_down).edge;
  }

  const FilteredBoundary& graph_;
  std::vector<std::uint32_t> first_ray_;
  std::vector<Ray> rays_;
  LeftRays left_rays_;
};

}  // namespace

ReadyBoundary::ReadyBoundary(const BoundaryGraph& graph) : graph_{{}, graph.edges} {
  points_.reserve(graph.points.size());
  graph_.points.reserve(graph.points.size());
  for (const Point& point : graph.points) graph_.points.push_back(&points_.emplace_back(point));
}

Walks boundary_walks(const FilteredBoundary& graph) { return WalkFinder(graph).find(); }

Walks boundary_walks(const BoundaryGraph& graph) {
  return boundary_walks(ReadyBoundary(graph).graph());
}

}  // namespace minkref::inline plane
