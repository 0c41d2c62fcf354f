#include "reference/disc/clearance/disc_on_path.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "reference/number/float_environment.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/location.hpp"

namespace minkref::inline disc {
namespace {

/// Closed segments with boxes for a search.
struct Segments {
  std::vector<ClosedSegment> exact;
  std::vector<NearSegment> near;
  plane::BoxTree tree;

  void add(const Point& a, const Point& b) {
    exact.push_back({a, b});
    near.emplace_back(exact.back());
  }
  void make_tree() {
    std::vector<plane::Box> boxes;
    for (const NearSegment& segment : near) {
      plane::Box box = box_of(segment.a);
      box.add(box_of(segment.b));
      boxes.push_back(box);
    }
    tree = plane::BoxTree(std::move(boxes));
  }
};

/// A lower bound of the squared distance of two boxes.
double squared_gap(const plane::Box& a, const plane::Box& b) {
  const auto gap = [](double low, double high, double other_low, double other_high) {
    return std::max({0.0, plane::below(other_low - high), plane::below(low - other_high)});
  };
  const double x = gap(a.xmin, a.xmax, b.xmin, b.xmax), y = gap(a.ymin, a.ymax, b.ymin, b.ymax);
  return std::max(0.0, (Interval(x) * Interval(x) + Interval(y) * Interval(y)).lower());
}

/// A segment of the path and an edge, and the least that their squared distance may be.
struct Pair {
  double least;
  std::uint32_t segment, edge;
};

/// The pairs that may be the nearest ones.
std::vector<Pair> nearest_pairs(const Segments& path, const Segments& edges) {
  double most = std::numeric_limits<double>::infinity();
  std::vector<Pair> pairs;
  path.tree.pairs_with(
      edges.tree, [&](const auto& a, const auto& b) { return squared_gap(a, b) <= most; },
      [&](std::uint32_t segment, std::uint32_t edge) {
        const Interval found = squared_distance(path.near[segment], edges.near[edge]);
        if (found.lower() > most) return false;
        most = std::min(most, found.upper());
        pairs.push_back({found.lower(), segment, edge});
        return false;
      });
  std::erase_if(pairs, [&](const Pair& pair) { return pair.least > most; });
  return pairs;
}

struct RingEdge {
  VertexId start, end;
};

}  // namespace

std::optional<DiscOnPath> largest_disc_on_path(const PolygonSet& obstacles,
                                               const std::vector<Point>& path) {
  const FloatEnvironment standard;
  if (path.empty()) throw BadInput("bad-path", "the path has no vertex", "give it one or more");
  if (obstacles.empty()) return std::nullopt;
  if (obstacles.is_region() && plane::locate(obstacles, path[0]) == plane::Location::inside) {
    return DiscOnPath{0, std::nullopt};
  }
  Segments way, edges;
  if (path.size() == 1) way.add(path[0], path[0]);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) way.add(path[k], path[k + 1]);
  std::vector<RingEdge> names;
  std::uint32_t ring_number = 0;
  const auto add_ring = [&](const Ring& ring) {
    const auto count = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t next = (k + 1) % count;
      edges.add(ring[k], ring[next]);
      names.push_back({{ring_number, k}, {ring_number, next}});
    }
    ++ring_number;
  };
  for (const Polygon& polygon : obstacles.polygons) {
    add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(hole);
  }
  way.make_tree();
  edges.make_tree();
  std::optional<DiscOnPath> best;
  const auto key = [](const DiscOnPath& found) {
    const DiscContact& contact = *found.contact;
    return std::tie(found.squared_radius, contact.at.segment, contact.at.t, contact.is_edge,
                    contact.feature.ring, contact.feature.index);
  };
  for (const Pair& pair : nearest_pairs(way, edges)) {
    look_for_interrupt();
    const ClosedSegment &segment = way.exact[pair.segment], &edge = edges.exact[pair.edge];
    const NearestPlaces found = nearest_places(segment, edge);
    const auto point = [](const ClosedSegment& of, const Rational& t) -> Point {
      return {of.a.x + t * (of.b.x - of.a.x), of.a.y + t * (of.b.y - of.a.y)};
    };
    const bool is_edge = found.u > 0 && found.u < 1;
    DiscOnPath one{found.squared,
                   DiscContact{{pair.segment, found.t, point(segment, found.t)},
                               is_edge,
                               found.u < 1 ? names[pair.edge].start : names[pair.edge].end,
                               point(edge, found.u)}};
    if (!best || key(one) < key(*best)) best = std::move(one);
  }
  return best;
}

}  // namespace minkref::inline disc
