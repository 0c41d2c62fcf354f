#include "reference/plane/erosion/erosion.hpp"

#include <stdexcept>

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/set_operations.hpp"
#include "reference/plane/erosion/outside.hpp"
#include "reference/plane/passages/bare_segments.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

/// The ends of a point or a segment, the lesser one first.
std::pair<Point, Point> ends_of(const PolygonSet& set) {
  const Ring& ring = set.polygons[0].outer;
  if (compare_xy(ring.back(), ring.front()) < 0) return {ring.back(), ring.front()};
  return {ring.front(), ring.back()};
}

/// Whether a segment or a point Q runs along the way from a to b, or either is a point.
bool parallel(const PolygonSet& Q, const Point& a, const Point& b) {
  const auto [c, d] = ends_of(Q);
  return (b.x - a.x) * (d.y - c.y) == (b.y - a.y) * (d.x - c.x);
}

Sum found_nothing() {
  Sum sum;
  sum.tight_passages.emplace();
  return sum;
}

/// `P - Q` for a point or a segment P: a point or a segment, or nothing.
Sum erosion_of_segment(const PolygonSet& P, const PolygonSet& Q) {
  Sum sum = found_nothing();
  if (Q.is_region()) return sum;
  const auto [a, b] = ends_of(P);
  const auto [c, d] = ends_of(Q);
  const Point first{a.x - c.x, a.y - c.y}, last{b.x - d.x, b.y - d.y};
  if (!parallel(Q, a, b) || compare_xy(last, first) < 0) return sum;
  TightPassage remnant{{first}, {{}}};
  if (last != first) remnant.points.push_back(last);
  sum.tight_passages->push_back(std::move(remnant));
  return sum;
}

void refuse_bad_erosion(const PolygonSet& Q, const Rational& scale) {
  if (sign(scale) <= 0) {
    throw BadInput("bad-scale", "the scale " + to_string(scale) + " is not greater than zero",
                   "give a scale s > 0");
  }
  if (Q.empty()) {
    throw BadInput("empty-operand", "Q is empty, so that every place is in the erosion",
                   "give a polygon set, a segment or a point");
  }
}

/// A summand without area, from one point to another.
PolygonSet between(const Point& a, const Point& b) {
  return a == b ? PolygonSet{{{{a}, {}}}} : PolygonSet{{{{a, b}, {}}}};
}

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }

/// Sweeps Q from a to b: adds a region, or a flat segment.
void add_swept(const PolygonSet& Q, const Point& a, const Point& b,
               std::vector<PolygonSet>& regions, std::vector<BareSegment>& segments) {
  if (Q.is_region()) {
    regions.push_back(minkowski_sum(between(a, b), Q, 1).region);
    return;
  }
  const auto [c, d] = ends_of(Q);
  if (parallel(Q, a, b)) {
    const auto [from, to] = ends_of(between(a, b));
    segments.push_back({from + c, to + d});
    return;
  }
  PolygonSet swept{{{{a + c, b + c, b + d, a + d}, {}}}};
  orient(swept);
  regions.push_back(std::move(swept));
}

}  // namespace

std::optional<Rational> least_scale_with_room(const PolygonSet& P, const PolygonSet& Q) {
  const ExactBox room(P), needed(Q);
  Rational least = 0;
  for (const auto& [in, own] :
       {std::pair(room.width(), needed.width()), std::pair(room.height(), needed.height())}) {
    if (own == 0) continue;
    if (in == 0) return std::nullopt;
    least = std::max(least, Rational(own / in));
  }
  return least;
}

PolygonSet negated(const PolygonSet& Q) {
  PolygonSet set = Q;
  const auto turn = [](Ring& ring) {
    for (Point& p : ring) p = {-p.x, -p.y};
  };
  for (Polygon& polygon : set.polygons) {
    turn(polygon.outer);
    for (Ring& hole : polygon.holes) turn(hole);
  }
  return set;
}

Canonical inside_out(const PolygonSet& sum) {
  // The box's component comes first: leftmost.
  PolygonSet rings;
  for (const Polygon& polygon : sum.polygons) {
    if (&polygon != &sum.polygons.front()) {
      rings.polygons.push_back({{polygon.outer.rbegin(), polygon.outer.rend()}, {}});
    }
    for (const Ring& hole : polygon.holes) {
      rings.polygons.push_back({{hole.rbegin(), hole.rend()}, {}});
    }
  }
  return canonicalize(rings);
}

Sum erosion(const PolygonSet& P, const PolygonSet& Q, const Rational& scale, Route route) {
  const FloatEnvironment standard;
  refuse_bad_erosion(Q, scale);
  if (P.empty()) return found_nothing();
  if (!P.is_region()) return erosion_of_segment(scaled(P, scale), Q);
  const auto least = least_scale_with_room(P, Q);
  if (!least || scale < *least) return found_nothing();
  const Outside outside = outside_of(P);
  Sum sum = minkowski_sum(outside.set, negated(Q), scale, route, "rational", Passages::find);
  Canonical inside = inside_out(sum.region);
  if (inside.components != sum.holes || inside.holes + 1 != sum.components) {
    throw std::logic_error("erosion: the holes of the sum are not those of a box");
  }
  sum.region = std::move(inside.region);
  sum.components = inside.components;
  sum.holes = inside.holes;
  for (TightPassage& remnant : *sum.tight_passages) {
    for (auto& contacts : remnant.contacts) {
      for (ConvolutionEdge& contact : contacts) contact = outside.in_operands(contact);
    }
  }
  return sum;
}

Sum opening(const PolygonSet& P, const PolygonSet& Q, const Rational& scale) {
  const FloatEnvironment standard;
  const Sum eroded = erosion(P, Q, scale);
  std::vector<PolygonSet> regions;
  std::vector<BareSegment> segments;
  if (!eroded.region.empty()) regions.push_back(minkowski_sum(eroded.region, Q, 1).region);
  for (const TightPassage& remnant : *eroded.tight_passages) {
    const auto& points = remnant.points;
    if (points.size() == 1) add_swept(Q, points[0], points[0], regions, segments);
    for (std::size_t i = 1; i < points.size(); ++i) {
      add_swept(Q, points[i - 1], points[i], regions, segments);
    }
  }
  Canonical united = combined(SetOperation::unite, regions);
  Sum sum;
  sum.tight_passages = segments_beside(united.region, std::move(segments));
  sum.region = std::move(united.region);
  sum.components = united.components;
  sum.holes = united.holes;
  return sum;
}

Sum closing(const PolygonSet& P, const PolygonSet& Q, const Rational& scale) {
  const FloatEnvironment standard;
  refuse_bad_erosion(Q, scale);
  const PolygonSet origin = between({0, 0}, {0, 0});
  if (Q.is_point() && !P.empty() && !P.is_region()) {
    return erosion_of_segment(scaled(P, scale), origin);
  }
  refuse_bad_operands(P, Q, scale);
  return erosion(minkowski_sum(P, Q, scale).region, Q, 1);
}

}  // namespace minkref::inline plane
