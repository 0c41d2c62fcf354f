// Random paths, many of them degenerate, and static sums as a judge of single scales.
#pragma once

#include <optional>

#include "reference/motion/valid_scales.hpp"
#include "reference/plane/sum.hpp"
#include "reference/plane/witness.hpp"
#include "tests/plane/random_cases.hpp"

namespace minkref::testing {

inline std::vector<Point> corners_of(const PolygonSet& set) {
  std::vector<Point> corners;
  for (const Polygon& polygon : set.polygons) {
    corners.insert(corners.end(), polygon.outer.begin(), polygon.outer.end());
    for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
  }
  return corners;
}

/// One vertex to four, on a grid, on corners of contact positions (o - s r), or along an edge of
/// such a position; some closed, some with a vertex twice in a row.
inline std::vector<Point> random_path(Source& random, const PolygonSet& part,
                                      const PolygonSet& obstacles) {
  const std::vector<Point> r = corners_of(part), o = corners_of(obstacles);
  const Rational scale = random_scale(random);
  const auto position = [&]() -> Point {
    if (random.below(3) != 0) {
      const int size = 12, halves = static_cast<int>(random.below(2)) + 1;
      return {Rational(random.between(-size, size), halves),
              Rational(random.between(-size, size), halves)};
    }
    const Point &a = r[random.below(r.size())], &b = o[random.below(o.size())];
    return {b.x - scale * a.x, b.y - scale * a.y};
  };
  std::vector<Point> path{position()};
  const auto more = random.below(4);
  for (std::size_t k = 0; k < more; ++k) {
    if (random.below(3) == 0) {  // along an edge of the obstacles
      const std::size_t i = random.below(o.size());
      const Point &a = o[i], &b = o[(i + 1) % o.size()];
      path.push_back({path.back().x + b.x - a.x, path.back().y + b.y - a.y});
    } else {
      path.push_back(position());
    }
  }
  if (random.below(6) == 0) path.push_back(path.front());
  if (random.below(10) == 0) path.push_back(path.back());
  return path;
}

inline std::string text(const std::vector<ScaleRange>& ranges) {
  std::string all;
  for (const ScaleRange& range : ranges) {
    all += (range.from_in() ? "[" : "(") + to_string(range.from.scale) + ", " +
           (range.to ? to_string(range.to->scale) : "inf") + (range.to_in() ? "] " : ") ");
  }
  return all.empty() ? "none" : all;
}

/// Reflected in the origin.
inline PolygonSet reflected_set(const PolygonSet& set) {
  PolygonSet result = scaled(set, Rational(-1));
  return result;
}

}  // namespace minkref::testing
