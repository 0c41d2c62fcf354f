#include "reference/motion/path_cuts.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"

namespace minkref::inline motion {
namespace {

Point from_to(const Point& a, const Point& b) { return {b.x - a.x, b.y - a.y}; }
Rational area_of(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Rational product_of(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// Adds the fractions of `way` at which another segment meets the line from `start` along `way`.
void add_cuts(const Point& start, const Point& way, const Segment& other,
              std::vector<Rational>& at) {
  const Point to_start = from_to(start, other.start), to_end = from_to(start, other.end);
  const Rational a = area_of(way, to_start), b = area_of(way, to_end);
  if (a == 0 && b == 0) {
    const Rational length = product_of(way, way);
    at.push_back(product_of(way, to_start) / length);
    at.push_back(product_of(way, to_end) / length);
    return;
  }
  if (sign(a) * sign(b) > 0) return;
  const Rational part = a / (a - b);
  const Point meeting{to_start.x + part * (to_end.x - to_start.x),
                      to_start.y + part * (to_end.y - to_start.y)};
  at.push_back(product_of(way, meeting) / product_of(way, way));
}

}  // namespace

PathCuts path_cuts(const std::vector<Point>& path, const std::vector<Segment>& segments) {
  PathCuts result;
  if (path.size() == 1) result.cuts.push_back(path[0]);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Point& start = path[i];
    const Point way = from_to(start, path[i + 1]);
    if (way == Point{}) {
      result.cuts.push_back(start);
      continue;
    }
    std::vector<Rational> at{0, 1};
    for (const Segment& segment : segments) {
      look_for_interrupt();
      add_cuts(start, way, segment, at);
    }
    std::erase_if(at, [](const Rational& t) { return t < 0 || t > 1; });
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    const auto point = [&](const Rational& t) {
      return Point{start.x + t * way.x, start.y + t * way.y};
    };
    for (std::size_t k = 0; k < at.size(); ++k) {
      result.cuts.push_back(point(at[k]));
      if (k + 1 < at.size()) result.between.push_back(point((at[k] + at[k + 1]) / 2));
    }
  }
  return result;
}

}  // namespace minkref::inline motion
