#include "reference/space/edges/faces_from_edges.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

#include "reference/interrupt.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"

namespace minkref::inline space {
namespace {

struct PlaneEdge {
  Point from, to;
};
bool less(const Point& a, const Point& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }
bool same_place(const PlaneEdge& a, const PlaneEdge& b) {
  return (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
}

OrientedPlane plane_of(const ConvolutionFacet& facet, const Integer& denominator) {
  const IntegerVector normal = primitive(facet.normal.exact);
  return {normal, Rational(dot(normal, facet.start<Integer>(0)), denominator)};
}

/// Cancels opposite edges, which merely touching parts of the boundary leave within a face.
std::vector<PlaneEdge> without_opposites(std::vector<PlaneEdge> edges) {
  const auto key = [](const PlaneEdge& e) {
    const bool forward = less(e.from, e.to);
    return std::pair<const Point&, const Point&>(forward ? e.from : e.to, forward ? e.to : e.from);
  };
  std::sort(edges.begin(), edges.end(), [&](const PlaneEdge& a, const PlaneEdge& b) {
    const auto [a_low, a_high] = key(a);
    const auto [b_low, b_high] = key(b);
    if (!(a_low == b_low)) return less(a_low, b_low);
    return less(a_high, b_high);
  });
  std::vector<PlaneEdge> left;
  for (std::size_t k = 0, end = 0; k < edges.size(); k = end) {
    long forward = 0;
    for (end = k; end < edges.size() && same_place(edges[k], edges[end]); ++end) {
      forward += edges[end].from == edges[k].from ? 1 : -1;
    }
    if (forward > 0) left.push_back(edges[k]);
    if (forward < 0) left.push_back({edges[k].to, edges[k].from});
  }
  return left;
}

PolygonSet region_within(const std::vector<PlaneEdge>& edges) {
  BoundaryGraph graph;
  for (const PlaneEdge& edge : edges) graph.points.push_back(edge.from);
  std::sort(graph.points.begin(), graph.points.end(), less);
  graph.points.erase(std::unique(graph.points.begin(), graph.points.end()), graph.points.end());
  const auto number = [&](const Point& point) {
    const auto at = std::lower_bound(graph.points.begin(), graph.points.end(), point, less);
    if (at == graph.points.end() || !(*at == point)) {
      throw std::logic_error("the edges of a face do not close");
    }
    return static_cast<std::uint32_t>(at - graph.points.begin());
  };
  for (const PlaneEdge& edge : edges) graph.edges.emplace_back(number(edge.from), number(edge.to));
  return canonical_form(graph).region;
}

}  // namespace

PolyhedralSet faces_from_edges(const std::vector<BoundaryEdge>& edges,
                               const std::vector<ConvolutionFacet>& facets,
                               const Integer& denominator) {
  std::map<OrientedPlane, std::vector<PlaneEdge>> planes;
  std::unordered_map<std::uint32_t, decltype(planes)::iterator> of_facet;
  const auto plane_at = [&](std::uint32_t facet) {
    const auto [found, fresh] = of_facet.try_emplace(facet);
    if (fresh) found->second = planes.try_emplace(plane_of(facets[facet], denominator)).first;
    return found->second;
  };
  const Rational unit(Integer(1), denominator);
  const auto scaled_down = [&](const SpacePoint& p) {
    return SpacePoint{p.x * unit, p.y * unit, p.z * unit};
  };
  for (const BoundaryEdge& edge : edges) {
    look_for_interrupt();
    const SpacePoint from = scaled_down(edge.from), to = scaled_down(edge.to);
    const auto add = [&](std::uint32_t facet, const SpacePoint& start, const SpacePoint& end) {
      auto& [plane, list] = *plane_at(facet);
      const std::size_t axis = viewing_axis(plane.normal);
      const Point a = seen(start, axis), b = seen(end, axis);
      list.push_back(is_mirrored(plane) ? PlaneEdge{b, a} : PlaneEdge{a, b});
    };
    add(edge.first, from, to);
    add(edge.second, to, from);
  }
  PolyhedralSet set;
  for (auto& [plane, list] : planes) {
    look_for_interrupt();
    const std::vector<PlaneEdge> rest = without_opposites(std::move(list));
    if (!rest.empty()) set.faces.push_back({plane, region_within(rest)});
  }
  return set;
}

}  // namespace minkref::inline space
