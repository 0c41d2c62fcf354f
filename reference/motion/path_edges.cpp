#include "reference/motion/path_edges.hpp"

#include "reference/interrupt.hpp"
#include "reference/plane/passages/wedge_walks.hpp"

namespace minkref::inline motion {
namespace {

Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point opposite(const Point& a) { return {-a.x, -a.y}; }
Rational cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// The scale at which a point a + s b meets the line through `on` with a direction; none if the
/// point stays on the line at all scales, or never meets it.
std::optional<Rational> scale_on_line(const Track& track, const Point& on, const Point& along) {
  const Rational slope = cross(along, track.b);
  if (slope == 0) return std::nullopt;
  return cross(along, minus(on, track.a)) / slope;
}

bool between(const Point& a, const Point& b, const Point& p) {  // on the line through both
  return dot(minus(p, a), minus(p, b)) <= 0;
}

/// The scale at which a track comes to a point.
std::optional<Rational> scale_at_point(const Track& track, const Point& p) {
  const Point way = minus(p, track.a);
  if (cross(way, track.b) != 0 || track.b == Point{}) return std::nullopt;
  return dot(way, track.b) / dot(track.b, track.b);
}

std::vector<Ring> walks_of(const PolygonSet& set) {
  const auto walks = wedge_walks(set);
  std::vector<Ring> rings;
  for (const Polygon& polygon : (walks ? walks->walks : set).polygons) {
    rings.push_back(polygon.outer);
    rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  }
  return rings;
}

/// Calls take(a, b, v): the edge from a to b of one set has the other set's sides at v on its
/// right.
template <class Take>
void each_contact(const std::vector<Ring>& edges, const std::vector<Ring>& vertices, Take&& take) {
  for (const Ring& ring : edges) {
    for (std::size_t i = 0; ring.size() > 1 && i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const Point along = minus(b, a);
      for (const Ring& other : vertices) {
        const std::size_t n = other.size();
        for (std::size_t k = 0; k < n; ++k) {
          look_for_interrupt();
          const Point& v = other[k];
          if (cross(along, minus(other[(k + 1) % n], v)) <= 0 &&
              cross(along, minus(other[(k + n - 1) % n], v)) <= 0) {
            take(a, b, v);
          }
        }
      }
    }
  }
}

}  // namespace

void add_meeting_scales(const PathEdge& edge, const std::vector<Point>& path,
                        std::vector<Rational>& scales) {
  const auto add_if = [&](const std::optional<Rational>& scale, const auto& holds) {
    if (scale && *scale > 0 && holds(*scale)) scales.push_back(*scale);
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    look_for_interrupt();
    add_if(scale_on_line(edge.from, path[i], edge.along),
           [&](const Rational& s) { return between(edge.from.at(s), edge.to.at(s), path[i]); });
    for (const Track* end : {&edge.from, &edge.to}) {
      add_if(scale_at_point(*end, path[i]), [](const Rational&) { return true; });
      if (i + 1 == path.size()) continue;
      add_if(scale_on_line(*end, path[i], minus(path[i + 1], path[i])),
             [&](const Rational& s) { return between(path[i], path[i + 1], end->at(s)); });
    }
  }
}

std::vector<PathEdge> contact_edges(const PolygonSet& part, const PolygonSet& obstacles) {
  const std::vector<Ring> of_robot = walks_of(part), of_obstacles = walks_of(obstacles);
  std::vector<PathEdge> edges;
  each_contact(of_obstacles, of_robot, [&](const Point& a, const Point& b, const Point& v) {
    edges.push_back({{a, opposite(v)}, {b, opposite(v)}, minus(b, a)});
  });
  each_contact(of_robot, of_obstacles, [&](const Point& a, const Point& b, const Point& v) {
    edges.push_back({{v, opposite(a)}, {v, opposite(b)}, minus(a, b)});
  });
  return edges;
}

}  // namespace minkref::inline motion
