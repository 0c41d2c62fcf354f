#include "reference/disc/curves/offset_patch.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "reference/plane/lines.hpp"

namespace minkref::inline disc {
namespace {

struct Corner {
  VertexId id;
  Point at;
};

bool is_straight(const Point& a, const Point& b, const Point& c) {
  const Direction in = from_to(a, b), out = from_to(b, c);
  return cross(in, out) == 0 && dot(in, out) > 0;
}

Direction reversed(const Direction& a) { return {-a.x, -a.y}; }

class Builder {
 public:
  void add(const Ring& ring, std::uint32_t number, std::uint32_t polygon) {
    std::vector<Corner> corners, before_first;
    std::vector<std::vector<Corner>> behind;  // of each corner: straight vertices up to the next
    const std::size_t n = ring.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Corner here{{number, static_cast<std::uint32_t>(k)}, ring[k]};
      if (n <= 2 || !is_straight(ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n])) {
        corners.push_back(here);
        behind.emplace_back();
      } else {
        (corners.empty() ? before_first : behind.back()).push_back(here);
      }
    }
    if (corners.size() == 1) {
      points_.push_back({corners[0], polygon});
      return;
    }
    std::copy(before_first.begin(), before_first.end(), std::back_inserter(behind.back()));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto edge = static_cast<std::uint32_t>(curves_.edges.size());
      for (const Corner& each : behind[k]) curves_.straight.push_back({edge, each.id, each.at});
      add_edge(corners[k], corners[(k + 1) % corners.size()], polygon);
    }
  }

  /// Completes the curves after the last ring.
  OffsetCurves finish() {
    const auto edges = static_cast<std::uint32_t>(curves_.edges.size());
    const auto offset = static_cast<std::uint32_t>(curves_.patches.size());
    for (std::uint32_t k = 0; k < edges; ++k) {
      const OffsetEdge& edge = curves_.edges[k];
      curves_.patches.push_back({edge.feature, edge.polygon, k, {}, {}, {}, OffsetPatch::none});
    }
    for (std::uint32_t k = 0; k < edges; ++k) join(k, offset);
    for (const auto& [corner, polygon] : points_) {
      add_circle(corner.at, polygon);
      if (points_.size() > 1 || edges > 0) add_point(corner, polygon);
    }
    return std::move(curves_);
  }

 private:
  std::uint32_t circle_about(const Point& p) {
    const auto [found, is_new] =
        circles_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(curves_.features.size()));
    if (is_new) curves_.features.push_back({OffsetPatch::none, p, false});
    return found->second;
  }

  std::uint32_t line_of(const Point& start, const Direction& along, std::uint32_t edge) {
    const Direction way = primitive(along);
    const auto [found, is_new] =
        lines_.try_emplace({way.x, way.y, way.y * start.x - way.x * start.y},
                           static_cast<std::uint32_t>(curves_.features.size()));
    if (is_new) curves_.features.push_back({edge, {}, false});
    return found->second;
  }

  void add_edge(const Corner& from, const Corner& to, std::uint32_t polygon) {
    const Direction along = from_to(from.at, to.at);
    const Direction normal{along.y, -along.x};
    const std::uint32_t start = circle_about(from.at), end = circle_about(to.at);
    const auto number = static_cast<std::uint32_t>(curves_.edges.size());
    const std::uint32_t feature = line_of(from.at, along, number);
    curves_.edges.push_back(
        {from.id, polygon, from.at, to.at, along, normal, dot(along, along), feature, start, end});
    leaving_[start].push_back(number);
  }

  /// Adds an edge of no length, so that others hear of a point.
  void add_point(const Corner& corner, std::uint32_t polygon) {
    const std::uint32_t feature = circle_about(corner.at);
    const Direction none{0, 0};
    curves_.edges.push_back(
        {corner.id, polygon, corner.at, corner.at, none, none, 0, feature, feature, feature});
  }

  /// Joins an edge to the next edge outside P, counter-clockwise about the edge's end. If both
  /// leave more than half a turn free, an arc joins them; each place has at most one arc.
  void join(std::uint32_t in, std::uint32_t offset) {
    const OffsetEdge& edge = curves_.edges[in];
    const Direction back = reversed(edge.along);
    const std::uint32_t out =
        next_outside(edge.along, leaving_[edge.end_feature],
                     [&](std::uint32_t k) -> const Direction& { return curves_.edges[k].along; });
    const Direction& ahead = curves_.edges[out].along;
    const Rational turn = cross(back, ahead);
    const bool is_flat = turn == 0 && dot(back, ahead) < 0;
    if (turn > 0) return;
    if (is_flat) {
      curves_.patches[offset + in].next = offset + out;
      return;
    }
    curves_.patches[offset + in].next = static_cast<std::uint32_t>(curves_.patches.size());
    Direction from = edge.normal;
    const Direction last = curves_.edges[out].normal;
    while (dot(from, last) < 0) {
      add_arc(edge.end, edge.end_feature, edge.polygon, from, turned(from));
      from = turned(from);
    }
    add_arc(edge.end, edge.end_feature, edge.polygon, from, last);
    curves_.patches.back().next = offset + out;
  }

  void add_arc(const Point& centre, std::uint32_t feature, std::uint32_t polygon,
               const Direction& first, const Direction& last) {
    const auto next = static_cast<std::uint32_t>(curves_.patches.size() + 1);
    curves_.features[feature].has_arc = true;
    curves_.patches.push_back({feature, polygon, OffsetPatch::none, centre, first, last, next});
  }

  void add_circle(const Point& centre, std::uint32_t polygon) {
    const std::uint32_t feature = circle_about(centre);
    const auto first = static_cast<std::uint32_t>(curves_.patches.size());
    Direction from{1, 0};
    for (int quarter = 0; quarter < 4; ++quarter) {
      add_arc(centre, feature, polygon, from, turned(from));
      from = turned(from);
    }
    curves_.patches.back().next = first;
  }

  OffsetCurves curves_;
  std::vector<std::pair<Corner, std::uint32_t>> points_;  ///< alone, with their polygons
  std::map<std::pair<Rational, Rational>, std::uint32_t> circles_;
  std::map<std::tuple<Rational, Rational, Rational>, std::uint32_t> lines_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> leaving_;  ///< edges, by where they start
};

}  // namespace

bool comes_before(const Direction& from, const Direction& x, const Direction& y) {
  const auto part = [&](const Direction& v) {
    const Rational c = cross(from, v);
    if (c > 0) return 0;
    if (c < 0) return 2;
    return dot(from, v) < 0 ? 1 : 3;
  };
  const int of_x = part(x), of_y = part(y);
  return of_x != of_y ? of_x < of_y : cross(x, y) > 0;
}

Direction primitive(const Direction& d) {
  namespace mp = boost::multiprecision;
  const Rational common(mp::denominator(d.x) * mp::denominator(d.y));
  const Integer x = mp::numerator(Rational(d.x * common)),
                y = mp::numerator(Rational(d.y * common));
  const Integer divisor = mp::gcd(x, y);
  return {Rational(Integer(x / divisor)), Rational(Integer(y / divisor))};
}

OffsetCurves offset_curves(const PolygonSet& P) {
  Builder builder;
  std::uint32_t ring = 0, number = 0;
  for (const Polygon& polygon : cut_lines(P).polygons) {
    builder.add(polygon.outer, ring++, number);
    for (const Ring& hole : polygon.holes) builder.add(hole, ring++, number);
    ++number;
  }
  return builder.finish();
}

}  // namespace minkref::inline disc
