// From walks to the canonical form: simple rings, collinear vertices merged, everything sorted.
#include <algorithm>
#include <numeric>

#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

/// Splits closed walks at repeated points.
class WalkSplitter {
 public:
  explicit WalkSplitter(std::size_t points) : place_(points, no_entry) {}

  std::vector<std::vector<std::uint32_t>> simple_rings(const std::vector<std::uint32_t>& walk) {
    std::vector<std::vector<std::uint32_t>> rings;
    std::vector<std::uint32_t> open;
    open.reserve(walk.size());
    for (const std::uint32_t point : walk) {
      look_for_interrupt();
      if (const std::uint32_t before = place_[point]; before != no_entry) {
        const auto& ring = rings.emplace_back(open.begin() + before, open.end());
        for (const std::uint32_t p : ring) place_[p] = no_entry;
        open.resize(before);
      }
      place_[point] = static_cast<std::uint32_t>(open.size());
      open.push_back(point);
    }
    for (const std::uint32_t p : open) place_[p] = no_entry;
    rings.push_back(std::move(open));
    return rings;
  }

 private:
  std::vector<std::uint32_t> place_;  ///< of points, in the ring that is not closed yet
};

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
  explicit RingBuilder(const FilteredBoundary& graph) : graph_(graph) {}

  /// Without collinear vertices, from the lexicographically smallest vertex; empty for a ring of no
  /// area.
  Ring build(const std::vector<std::uint32_t>& indices) const {
    std::vector<std::uint32_t> kept;
    kept.reserve(indices.size());
    const std::size_t n = indices.size();
    for (std::size_t i = 0; i < n; ++i) {
      look_for_interrupt();
      // The rings are simple, so a vertex on the line of its neighbours lies between the two.
      if (orientation(point(indices[i == 0 ? n - 1 : i - 1]), point(indices[i]),
                      point(indices[i + 1 == n ? 0 : i + 1])) != 0) {
        kept.push_back(indices[i]);
      }
    }
    if (kept.empty()) return {};
    const auto least = std::min_element(
        kept.begin(), kept.end(),
        [&](std::uint32_t a, std::uint32_t b) { return compare_xy(point(a), point(b)) < 0; });
    std::rotate(kept.begin(), least, kept.end());
    Ring ring;
    ring.reserve(kept.size());
    for (const std::uint32_t p : kept) ring.push_back(point(p).exact());
    return ring;
  }

  /// A ring's first vertex is its least, where the turn has the ring's sign.
  static bool counter_clockwise(const Ring& ring) {
    return orientation(FilteredPoint(ring.back()), FilteredPoint(ring[0]), FilteredPoint(ring[1])) >
           0;
  }

 private:
  const FilteredPoint& point(std::uint32_t p) const { return *graph_.points[p]; }

  const FilteredBoundary& graph_;
};

}  // namespace

CanonicalParts canonical_parts(const FilteredBoundary& graph) {
  const Walks walks = boundary_walks(graph);
  CanonicalParts parts;
  Canonical& result = parts.form;
  result.components = walks.components;
  result.holes = walks.holes;
  result.region.polygons.resize(walks.components);
  const RingBuilder builder(graph);
  WalkSplitter splitter(graph.points.size());
  for (const Walk& walk : walks.walks) {
    if (walk.component >=
        walks.components) {  // only possible where a rounding arithmetic built the graph
      result.well_formed = false;
      continue;
    }
    Polygon& polygon = result.region.polygons[walk.component];
    for (const auto& indices : splitter.simple_rings(walk.points)) {
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

CanonicalParts canonical_parts(const BoundaryGraph& graph) {
  return canonical_parts(ReadyBoundary(graph).graph());
}

Canonical canonical_form(const FilteredBoundary& graph) { return canonical_parts(graph).form; }
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
