// From walks to the canonical form: simple rings, collinear vertices merged, everything sorted.
#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "reference/interrupt.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

/// Splits a closed walk at repeated points.
std::vector<std::vector<std::uint32_t>> simple_rings(const std::vector<std::uint32_t>& walk) {
  std::vector<std::vector<std::uint32_t>> rings;
  std::vector<std::uint32_t> open;
  std::unordered_map<std::uint32_t, std::size_t> position;
  for (const std::uint32_t point : walk) {
    look_for_interrupt();
    const auto found = position.find(point);
    if (found != position.end()) {
      auto& ring =
          rings.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(found->second), open.end());
      for (const std::uint32_t p : ring) position.erase(p);
      open.resize(open.size() - ring.size());
    }
    position.emplace(point, open.size());
    open.push_back(point);
  }
  rings.push_back(std::move(open));
  return rings;
}

int compare_rings(const Ring& a, const Ring& b) {
  look_for_interrupt();
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    const int order = compare_xy(a[i], b[i]);
    if (order != 0) return order;
  }
  return a.size() < b.size() ? -1 : a.size() > b.size() ? 1 : 0;
}

class RingBuilder {
 public:
  explicit RingBuilder(const BoundaryGraph& graph) {
    points_.reserve(graph.points.size());
    for (const Point& point : graph.points) points_.emplace_back(point);
  }

  /// Without collinear vertices, from the lexicographically smallest vertex; empty for a ring of no
  /// area.
  Ring build(const std::vector<std::uint32_t>& indices) const {
    std::vector<std::uint32_t> kept;
    const std::size_t n = indices.size();
    for (std::size_t i = 0; i < n; ++i) {
      look_for_interrupt();
      // The rings are simple, so a vertex on the line of its neighbours lies between the two.
      if (orientation(points_[indices[(i + n - 1) % n]], points_[indices[i]],
                      points_[indices[(i + 1) % n]]) != 0) {
        kept.push_back(indices[i]);
      }
    }
    if (kept.empty()) return {};
    const auto least = std::min_element(
        kept.begin(), kept.end(),
        [&](std::uint32_t a, std::uint32_t b) { return compare_xy(points_[a], points_[b]) < 0; });
    std::rotate(kept.begin(), least, kept.end());
    Ring ring;
    ring.reserve(kept.size());
    for (const std::uint32_t p : kept) ring.push_back(points_[p].exact());
    return ring;
  }

  /// A ring's first vertex is its least, where the turn has the ring's sign.
  static bool counter_clockwise(const Ring& ring) {
    return orientation(FilteredPoint(ring.back()), FilteredPoint(ring[0]), FilteredPoint(ring[1])) >
           0;
  }

 private:
  std::vector<FilteredPoint> points_;
};

}  // namespace

CanonicalParts canonical_parts(const BoundaryGraph& graph) {
  const Walks walks = boundary_walks(graph);
  CanonicalParts parts;
  Canonical& result = parts.form;
  result.components = walks.components;
  result.holes = walks.holes;
  result.region.polygons.resize(walks.components);
  const RingBuilder builder(graph);
  for (const Walk& walk : walks.walks) {
    if (walk.component >=
        walks.components) {  // only possible where a rounding arithmetic built the graph
      result.well_formed = false;
      continue;
    }
    Polygon& polygon = result.region.polygons[walk.component];
    for (const auto& indices : simple_rings(walk.points)) {
      Ring ring = builder.build(indices);
      if (ring.size() < 3) {
        result.well_formed = false;
        continue;
      }
      if (RingBuilder::counter_clockwise(ring) && polygon.outer.empty()) {
        polygon.outer = std::move(ring);
      } else {
        if (RingBuilder::counter_clockwise(ring)) result.well_formed = false;
        polygon.holes.push_back(std::move(ring));
      }
    }
  }
  const auto less = [](const Ring& a, const Ring& b) { return compare_rings(a, b) < 0; };
  for (Polygon& polygon : result.region.polygons)
    std::sort(polygon.holes.begin(), polygon.holes.end(), less);
  std::vector<std::uint32_t> order(walks.components), place(walks.components);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return less(result.region.polygons[a].outer, result.region.polygons[b].outer);
  });
  std::vector<Polygon> sorted;
  sorted.reserve(order.size());
  for (const std::uint32_t component : order) {
    place[component] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(std::move(result.region.polygons[component]));
  }
  result.region.polygons = std::move(sorted);
  parts.polygon_of.reserve(graph.edges.size());
  for (const std::uint32_t walk : walks.walk_of) {
    const std::uint32_t component = walks.walks[walk].component;
    parts.polygon_of.push_back(component < place.size() ? place[component] : component);
  }
  return parts;
}

Canonical canonical_form(const BoundaryGraph& graph) { return canonical_parts(graph).form; }

std::string canonical_json(const PolygonSet& canonical) {
  std::string text = "{\"polygons\":[";
  const auto add_ring = [&](const Ring& ring) {
    text += '[';
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (i > 0) text += ',';
      text.append("[\"").append(to_string(ring[i].x)).append("\",\"");
      text.append(to_string(ring[i].y)).append("\"]");
    }
    text += ']';
  };
  for (std::size_t p = 0; p < canonical.polygons.size(); ++p) {
    const Polygon& polygon = canonical.polygons[p];
    text += p > 0 ? ",{\"holes\":[" : "{\"holes\":[";
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
      if (h > 0) text += ',';
      add_ring(polygon.holes[h]);
    }
    text += "],\"outer\":";
    add_ring(polygon.outer);
    text += '}';
  }
  return text + "]}";
}

}  // namespace minkref::inline plane
