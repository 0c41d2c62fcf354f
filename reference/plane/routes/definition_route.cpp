#include "reference/plane/routes/definition_route.hpp"

#include <map>

#include "reference/interrupt.hpp"
#include "reference/plane/kernel/exact_frame.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/routes.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::inline plane {
namespace {

struct PointPair {
  Point start, end;
};

/// The operand's triangles as separate polygons; points and segments stay.
PolygonSet as_triangles(const PolygonSet& set) {
  if (!has_area(set)) return set;
  PolygonSet result;
  for (const Triangle& t : triangulate(set))
    result.polygons.push_back({Ring(t.begin(), t.end()), {}});
  return result;
}

/// Joins boundary pieces to a graph: equal ends become one point, and another piece's end cuts a
/// piece.
BoundaryGraph join(const std::vector<PointPair>& pieces) {
  const auto before = [](const Point& a, const Point& b) { return compare_xy(a, b) < 0; };
  std::map<Point, std::uint32_t, decltype(before)> known(before);
  BoundaryGraph graph;
  const auto number = [&](const Point& p) {
    const auto [place, fresh] =
        known.try_emplace(p, static_cast<std::uint32_t>(graph.points.size()));
    if (fresh) graph.points.push_back(p);
    return place->second;
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> whole;
  for (const PointPair& piece : pieces) {
    const std::uint32_t from = number(piece.start);
    whole.emplace_back(from, number(piece.end));
  }
  std::vector<FilteredPoint> points;
  std::vector<Box> boxes;
  for (const Point& p : graph.points) {
    const FilteredPoint& point = points.emplace_back(p);
    boxes.push_back({below(point.x()), below(point.y()), above(point.x()), above(point.y())});
  }
  const std::vector<Box> at = boxes;
  const BoxTree tree(std::move(boxes));
  for (const auto& [from, to] : whole) {
    Box box = at[from];
    box.add(at[to]);
    std::vector<std::uint32_t> on;
    const std::uint32_t a = from, b = to;
    tree.query(box, [&](std::uint32_t p) {
      if (p != a && p != b && orientation(points[a], points[b], points[p]) == 0 &&
          compare_xy(points[a], points[p]) * compare_xy(points[p], points[b]) > 0) {
        on.push_back(p);
      }
      return false;
    });
    const int sense = compare_xy(points[a], points[b]);
    std::sort(on.begin(), on.end(), [&](std::uint32_t p, std::uint32_t q) {
      return compare_xy(points[p], points[q]) * sense > 0;
    });
    on.push_back(b);
    std::uint32_t previous = a;
    for (const std::uint32_t p : on) {
      graph.edges.emplace_back(previous, p);
      previous = p;
    }
  }
  return graph;
}

}  // namespace

BoundaryGraph definition_route(const PolygonSet& P, const PolygonSet& Q, Statistics& statistics) {
  return on_exact_frame(as_triangles(P), as_triangles(Q), [&](const auto& frame) {
    using K = typename std::decay_t<decltype(frame)>::K;
    statistics.kernel = frame.name();
    ConvexUnion<K> sums(frame.kernel);
    for (const auto& p : frame.P.rings) {
      for (const auto& q : frame.Q.rings) {
        look_for_interrupt();
        auto sum = convex_sum(frame.kernel, p, q);
        if (sum.size() >= 3) sums.add(std::move(sum));
      }
    }
    std::vector<PointPair> pieces;
    for (const auto& piece : sums.boundary()) {
      pieces.push_back(
          {position(frame, frame.kernel.node(piece.start, piece.direction, piece.from)),
           position(frame, frame.kernel.node(piece.start, piece.direction, piece.to))});
    }
    add_counts(statistics, frame.kernel.counts);
    return join(pieces);
  });
}

}  // namespace minkref::inline plane
