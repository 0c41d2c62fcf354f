#include "reference/motion/valid_scales.hpp"

#include <algorithm>

#include "reference/error.hpp"
#include "reference/motion/routes.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline motion {

PolygonSet half_turned(const PolygonSet& set) {
  PolygonSet result = set;
  const auto turn = [](Ring& ring) {
    for (Point& p : ring) p = {-p.x, -p.y};
  };
  for (Polygon& polygon : result.polygons) {
    turn(polygon.outer);
    for (Ring& hole : polygon.holes) turn(hole);
  }
  return result;
}

ScaleSet decided_at(std::vector<Rational> critical, const ScaleWindow& window,
                    const std::function<bool(const Rational&)>& collides) {
  const ScaleRange all = range_of(window);
  for (const auto& bound : {window.from, window.to}) {
    if (bound) critical.push_back(*bound);  // something may happen there
  }
  std::sort(critical.begin(), critical.end());
  critical.erase(std::unique(critical.begin(), critical.end()), critical.end());
  std::erase_if(critical, [&](const Rational& s) { return !all.holds(s); });
  ScaleSet result;
  const auto decide = [&](const ScaleCut& from, const std::optional<ScaleCut>& to) {
    if (to && !(from < *to)) return;
    if (collides(ScaleRange{from, to}.sample())) result.add(from, to);
  };
  ScaleCut from = all.from;
  for (const Rational& scale : critical) {
    decide(from, ScaleCut{scale, false});
    decide({scale, false}, ScaleCut{scale, true});
    from = {scale, true};
  }
  decide(from, all.to);
  return result;
}

void refuse_bad_problem(const PolygonSet& part, const PolygonSet& obstacles,
                        const std::vector<Point>& path, const ScaleWindow& window) {
  refuse_bad_window(window);
  if (path.empty()) {
    throw BadInput("bad-path", "a path has at least one vertex", "give it one");
  }
  if (part.empty() || obstacles.empty()) return;
  if (!part.is_region() && !obstacles.is_region()) {
    throw BadInput("degenerate-operands", "both the part and the obstacles are without area",
                   "only one of them may be a point or a segment");
  }
}

ValidScales valid_scales(const PolygonSet& part, const PolygonSet& obstacles,
                         const std::vector<Point>& path, ContactRule rule,
                         const ScaleWindow& window, PathRoute route) {
  const FloatEnvironment standard;
  refuse_bad_problem(part, obstacles, path, window);
  ValidScales result;
  if (part.empty() || obstacles.empty()) {
    result.valid = ScaleSet().left_of(window);
    return result;
  }
  const PathProblem problem{part, obstacles, path, rule, window};
  const auto collisions = route == PathRoute::pieces     ? collisions_of_pieces
                          : route == PathRoute::contacts ? collisions_by_contacts
                                                         : collisions_by_index;
  result.valid = collisions(problem, result.statistics).left_of(window);
  result.bounds = bounds_of(problem, result.valid);
  return result;
}

ContactRule contact_rule(std::string_view name) {
  if (name == "allowed") return ContactRule::allowed;
  if (name == "forbidden") return ContactRule::forbidden;
  throw BadInput("no-rule", "there is no rule of contact \"" + std::string(name) + "\"",
                 "choose allowed or forbidden");
}

PathRoute path_route(std::string_view name) {
  if (name == "pieces") return PathRoute::pieces;
  if (name == "contacts") return PathRoute::contacts;
  if (name == "index") return PathRoute::index;
  throw BadInput("no-route", "there is no route \"" + std::string(name) + "\" of a path",
                 "choose pieces, contacts or index");
}

bool star_shaped(const PolygonSet& part) {
  const FloatEnvironment standard;
  const auto sees = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (a.x * b.y - a.y * b.x < 0) return false;  // the origin is on the right
    }
    return true;
  };
  if (part.empty()) return true;
  if (part.is_point()) return part.polygons[0].outer[0] == Point{};
  if (part.is_segment()) {
    const Point &a = part.polygons[0].outer[0], &b = part.polygons[0].outer[1];
    return a.x * b.y == a.y * b.x && a.x * b.x + a.y * b.y <= 0;
  }
  return std::all_of(part.polygons.begin(), part.polygons.end(), [&](const Polygon& polygon) {
    return sees(polygon.outer) && std::all_of(polygon.holes.begin(), polygon.holes.end(), sees);
  });
}

}  // namespace minkref::inline motion
