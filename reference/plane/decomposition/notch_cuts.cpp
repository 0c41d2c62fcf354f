#include "reference/plane/decomposition/notch_cuts.hpp"

#include <map>
#include <utility>

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/set_boundary.hpp"
#include "reference/plane/decomposition/wall_search.hpp"

namespace minkref::inline plane {
namespace {

struct ByPlace {
  bool operator()(const FilteredPoint& a, const FilteredPoint& b) const {
    return compare_xy(a, b) < 0;
  }
};
/// Walls at points.
using WallRays = std::map<FilteredPoint, std::vector<WallRay>, ByPlace>;

std::vector<FilteredPoint> filtered(const BoundaryGraph& graph) {
  return {graph.points.begin(), graph.points.end()};
}

class NotchCutter {
 public:
  NotchCutter(const PolygonSet& P, const std::vector<Point>& notches) {
    if (P.is_region()) result_.boundary = set_boundary(P).graph;
    for (const Point& notch : notches)
      notches_.push_back(rays_.try_emplace(FilteredPoint(notch)).first);
    const std::vector<FilteredPoint> points = filtered(result_.boundary);
    for (const auto& [from, to] : result_.boundary.edges) {
      walls_.add(points[from], points[to]);
      add_ray(points[from], points[to], true);
      add_ray(points[to], points[from], false);
    }
  }

  NotchCuts cut() && {
    for (std::uint32_t notch = 0; notch < notches_.size(); ++notch) {
      look_for_interrupt();
      const auto& [at, rays] = *notches_[notch];
      if (rays.empty()) refuse(at.exact());
      const std::optional<ResolvingCone> cone = resolving_cone(at, rays);
      if (!cone) continue;
      WallSearch::Hit hit = walls_.nearest(*cone);
      const FilteredPoint end(hit.at);
      result_.cuts.push_back({at.exact(), std::move(hit.at), notch, hit.wall});
      walls_.add(at, end);
      add_ray(at, end, true);
      add_ray(end, at, true);
    }
    return std::move(result_);
  }

 private:
  void add_ray(const FilteredPoint& at, const FilteredPoint& to, bool interior_after) {
    const auto found = rays_.find(at);
    if (found != rays_.end()) found->second.push_back({to, interior_after});
  }

  [[noreturn]] static void refuse(const Point& at) {
    throw BadInput("no-notch",
                   "(" + to_string(at.x) + ", " + to_string(at.y) + ") is no vertex of the set",
                   "give vertices of the set");
  }

  NotchCuts result_;
  WallRays rays_;  ///< at notches only
  std::vector<WallRays::iterator> notches_;
  WallSearch walls_;
};

}  // namespace

NotchCuts notch_cuts(const PolygonSet& P, const std::vector<Point>& notches) {
  const FloatEnvironment standard;
  return NotchCutter(P, notches).cut();
}

std::vector<Point> reflex_vertices(const PolygonSet& P) {
  const FloatEnvironment standard;
  std::vector<Point> found;
  if (!P.is_region()) return found;
  const BoundaryGraph graph = set_boundary(P).graph;
  const std::vector<FilteredPoint> points = filtered(graph);
  WallRays rays;
  for (const auto& [from, to] : graph.edges) {
    rays[points[from]].push_back({points[to], true});
    rays[points[to]].push_back({points[from], false});
  }
  for (const auto& [at, walls] : rays) {
    if (resolving_cone(at, walls)) found.push_back(at.exact());
  }
  return found;
}

}  // namespace minkref::inline plane
