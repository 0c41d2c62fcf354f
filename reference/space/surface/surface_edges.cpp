#include "reference/space/surface/surface_edges.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/location.hpp"
#include "reference/space/surface/faces_about_edges.hpp"

namespace minkref::inline space {
namespace {

/// One region's border and slits as a plane graph, with the points' numbers.
struct RegionGraph {
  BoundaryGraph graph;
  std::vector<std::uint32_t> points;

  RegionGraph(const ConformingEdges& edges, std::size_t region, std::size_t axis) {
    const std::vector<PointPair>&border = edges.borders[region], &slits = edges.slits[region];
    for (const auto* list : {&border, &slits}) {
      for (const auto& [from, to] : *list) {
        points.push_back(from);
        points.push_back(to);
      }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const std::uint32_t p : points) graph.points.push_back(seen(edges.points[p].exact, axis));
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
      graph.edges.emplace_back(place_of(from), place_of(to));
    };
    for (const auto& [from, to] : border) add(from, to);
    for (const auto& [from, to] : slits) add(from, to), add(to, from);
  }

 private:
  std::uint32_t place_of(std::uint32_t point) const {
    return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), point) -
                                      points.begin());
  }
};

class SurfaceBuild {
 public:
  SurfaceEdges run(const PolyhedralSet& set) {
    ConformingEdges edges = conforming_edges(set);
    for (std::size_t r = 0; r < set.faces.size(); ++r) {
      surface_.planes.push_back(set.faces[r].plane);
      add_region(edges, r);
    }
    surface_.points = std::move(edges.points);
    pair_faces_about_edges(surface_);
    return std::move(surface_);
  }

 private:
  void add_region(const ConformingEdges& edges, std::size_t region) {
    const OrientedPlane& plane = surface_.planes[region];
    const RegionGraph local(edges, region, viewing_axis(plane.normal));
    const Walks walks = boundary_walks(local.graph);
    const auto base = static_cast<std::uint32_t>(surface_.faces.size());
    surface_.faces.resize(base + walks.components, {static_cast<std::uint32_t>(region), {}, {}});
    for (const Walk& walk : walks.walks) {
      std::vector<std::uint32_t> corners;
      for (const std::uint32_t p : walk.points) corners.push_back(local.points[p]);
      if (is_mirrored(plane)) std::reverse(corners.begin(), corners.end());
      const std::uint32_t face = base + walk.component;
      auto& starts = surface_.faces[face].walks;
      starts.insert(walk.encloses ? starts.begin() : starts.end(), add_walk(corners, face));
    }
    for (const std::uint32_t tip : edges.tips[region]) add_tip(local, walks, base, edges, tip);
  }

  /// Adds a tip to the face around it: inside the face's outer walk and outside all inner walks.
  void add_tip(const RegionGraph& local, const Walks& walks, std::uint32_t base,
               const ConformingEdges& edges, std::uint32_t tip) {
    const std::size_t axis = viewing_axis(surface_.planes[surface_.faces[base].plane].normal);
    const FilteredPoint point(seen(edges.points[tip].exact, axis));
    std::vector<int> within(walks.components, 0);
    for (const Walk& walk : walks.walks) {
      FilteredRing ring;
      for (const std::uint32_t p : walk.points) ring.emplace_back(local.graph.points[p]);
      const bool inside = locate(ring, point) == Location::inside;
      within[walk.component] += walk.encloses ? inside : -static_cast<int>(inside);
    }
    const auto at = std::find(within.begin(), within.end(), 1);
    if (at == within.end()) throw std::logic_error("a tip touches no face");
    surface_.faces[base + static_cast<std::size_t>(at - within.begin())].tips.push_back(tip);
  }

  std::uint32_t add_walk(const std::vector<std::uint32_t>& corners, std::uint32_t face) {
    const auto first = static_cast<std::uint32_t>(surface_.half_edges.size());
    const auto size = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t k = 0; k < size; ++k) {
      const std::uint32_t after = (k + 1) % size;
      surface_.half_edges.push_back(
          {corners[k], corners[after], face, first + after, {no_entry, no_entry}});
    }
    return first;
  }

  SurfaceEdges surface_;
};

}  // namespace

std::vector<std::uint32_t> SurfaceEdges::walk(std::uint32_t first) const {
  std::vector<std::uint32_t> result;
  std::uint32_t at = first;
  do {
    result.push_back(at);
    at = half_edges[at].next;
  } while (at != first);
  return result;
}

SurfaceEdges surface_edges(const PolyhedralSet& set) {
  const FloatEnvironment standard;
  return SurfaceBuild().run(set);
}

}  // namespace minkref::inline space
