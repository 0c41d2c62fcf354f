#include "reference/scene/point_cover.hpp"

#include <algorithm>

namespace minkref::inline scene {
namespace {

Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
Rational cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }

/// The sign of a + b e + c e^2 for all small e > 0.
int sign_near(const Rational& a, const Rational& b, const Rational& c) {
  if (const int s = sign(a); s != 0) return s;
  if (const int s = sign(b); s != 0) return s;
  return sign(c);
}

/// Whether a set has the points p + e along + e^2 aside for all small e > 0, which lie on no edge.
bool covers(const std::vector<ObstacleEdge>& set, const Point& p, const Point& along,
            const Point& aside) {
  int winding = 0;
  for (const auto& [a, b] : set) {
    const bool first = sign_near(a.y - p.y, -along.y, -aside.y) > 0;
    const bool second = sign_near(b.y - p.y, -along.y, -aside.y) > 0;
    if (first == second) continue;
    const Point u = minus(b, a);
    const bool left = sign_near(cross(u, minus(p, a)), cross(u, along), cross(u, aside)) > 0;
    if (second && left) ++winding;
    if (first && !left) --winding;
  }
  return winding > 0;
}

/// The directions in which edges leave a point.
std::vector<Point> rays(const std::vector<std::vector<ObstacleEdge>>& sets, const Point& p) {
  std::vector<Point> found;
  for (const auto& set : sets) {
    for (const ObstacleEdge& edge : set) {
      if (!lies_on(edge, p)) continue;
      for (const Point& end : {edge.from, edge.to}) {
        if (end != p) found.push_back(minus(end, p));
      }
    }
  }
  return found;
}

}  // namespace

bool lies_on(const ObstacleEdge& edge, const Point& p) {
  if (edge.from == edge.to) return p == edge.from;
  const Point u = minus(edge.to, edge.from), w = minus(p, edge.from);
  if (sign(cross(u, w)) != 0) return false;
  const Rational along = u.x * w.x + u.y * w.y;
  return along >= 0 && along <= u.x * u.x + u.y * u.y;
}

bool cover_together(const std::vector<std::vector<ObstacleEdge>>& sets, const Point& p) {
  const std::vector<Point> all = rays(sets, p);
  const auto held = [&](const Point& ray, const Point& aside) {
    return std::any_of(sets.begin(), sets.end(),
                       [&](const auto& set) { return covers(set, p, ray, aside); });
  };
  return !all.empty() && std::all_of(all.begin(), all.end(), [&](const Point& ray) {
    return held(ray, {-ray.y, ray.x}) && held(ray, {ray.y, -ray.x});
  });
}

}  // namespace minkref::inline scene
