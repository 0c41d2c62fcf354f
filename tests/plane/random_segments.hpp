// Random segments, degenerate on purpose: many through a point, overlaps, vertices on segments.
#pragma once

#include "tests/number/random_numbers.hpp"
#include "tests/plane/contact_by_edges.hpp"

namespace minkref::testing {

inline Point random_grid_point(Source& random, int size) {
  return {random.between(0, size), random.between(0, size)};
}

inline std::vector<Edge> random_segments(Source& random) {
  std::vector<Edge> all;
  const int size = random.between(2, 7), count = random.between(1, 14);
  const Point hub{Rational(random.between(0, 6), 3), Rational(random.between(0, 6), 3)};
  const int kind = random.between(0, 5);
  const auto add = [&](const Point& a, const Point& b) {
    if (a != b) all.push_back({a, b});
  };
  for (int i = 0; i < count; ++i) {
    const Point a = random_grid_point(random, size), b = random_grid_point(random, size);
    switch (kind == 5 ? random.between(0, 4) : kind) {
      case 0:  // anything
        add(a, b);
        break;
      case 1:  // through one point
        add(a, hub + (hub - a));
        break;
      case 2:  // horizontal and vertical
        add(a, random.coin() ? Point{a.x, b.y} : Point{b.x, a.y});
        break;
      case 3:  // on one of three lines
        add({a.x, Rational(random.between(0, 2) - 1) * a.x}, {b.x, Rational(i % 3 - 1) * b.x});
        add({a.x, a.x}, {b.x, b.x});
        break;
      default:  // a copy of an earlier one, or a part of it, perhaps turned round
        if (all.empty()) {
          add(a, b);
        } else {
          const Edge e = all[random.below(all.size())];
          const Point from = e.from + Rational(random.between(-1, 1), 2) * (e.to - e.from);
          add(random.coin() ? e.to : from, random.coin() ? from : b);
        }
    }
  }
  if (all.empty()) all.push_back({{0, 0}, {1, 0}});
  return all;
}

}  // namespace minkref::testing
