// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/cgal/vanishing_holes.hpp"

#include <algorithm>

namespace minkref::cgal_oracle {
namespace {

struct Extent {
  mpq_class width, height;
};

Extent extent(const Ring& ring) {
  const auto [left, right] = std::minmax_element(
      ring.begin(), ring.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(
      ring.begin(), ring.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  return {right->x - left->x, high->y - low->y};
}

}  // namespace

Polygon without_vanishing_holes(const Polygon& p, const Polygon& q) {
  Polygon kept{p.outer, {}};
  if (p.holes.empty()) return kept;
  const Extent other = extent(q.outer);
  for (const Ring& hole : p.holes) {
    const Extent room = extent(hole);
    if (room.width > other.width && room.height > other.height) kept.holes.push_back(hole);
  }
  return kept;
}

}  // namespace minkref::cgal_oracle
