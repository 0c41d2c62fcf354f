#include "reference/motion/star_centre.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"

namespace minkref::inline motion {
namespace {

Rational side_of(const Point& a, const Point& b, const Point& x) {
  return (b.x - a.x) * (x.y - a.y) - (b.y - a.y) * (x.x - a.x);
}

/// The part of a convex polygon on the left of a line, with the line.
Ring left_part(const Ring& polygon, const Point& a, const Point& b) {
  Ring rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational at_p = side_of(a, b, p), at_q = side_of(a, b, q);
    if (at_p >= 0) rest.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      const Rational part = at_p / (at_p - at_q);
      rest.push_back({p.x + part * (q.x - p.x), p.y + part * (q.y - p.y)});
    }
  }
  return rest;
}

Point middle_of(const Ring& ring) {
  Point sum;
  for (const Point& p : ring) sum = {sum.x + p.x, sum.y + p.y};
  const Rational count = static_cast<long>(ring.size());
  return {sum.x / count, sum.y / count};
}

bool is_one_ring(const PolygonSet& set) {
  return set.is_region() && set.polygons.size() == 1 && set.polygons[0].holes.empty();
}

}  // namespace

bool is_inner_star_centre(const PolygonSet& set, const Point& at) {
  if (!is_one_ring(set)) return false;
  const Ring& ring = set.polygons[0].outer;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (side_of(ring[i], ring[(i + 1) % ring.size()], at) <= 0) return false;
  }
  return true;
}

std::optional<StarCentre> star_centre(const PolygonSet& set) {
  if (set.empty()) return std::nullopt;
  if (!set.is_region()) return StarCentre{set.polygons[0].outer[0], false};
  if (!is_one_ring(set)) return std::nullopt;
  const Ring& ring = set.polygons[0].outer;
  const auto edge = [&](std::size_t i) -> std::pair<const Point&, const Point&> {
    return {ring[i], ring[(i + 1) % ring.size()]};
  };
  bool is_convex = true;
  for (std::size_t i = 0; i < ring.size() && is_convex; ++i) {
    const auto [a, b] = edge(i);
    is_convex = side_of(a, b, ring[(i + 2) % ring.size()]) >= 0;
  }
  if (is_convex) return StarCentre{middle_of(ring), true};
  Point low = ring[0], high = ring[0];
  for (const Point& p : ring) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  Ring kernel{low, {high.x, low.y}, high, {low.x, high.y}};
  for (std::size_t i = 0; i < ring.size() && !kernel.empty(); ++i) {
    look_for_interrupt();
    const auto [a, b] = edge(i);
    kernel = left_part(kernel, a, b);
  }
  if (kernel.empty()) return std::nullopt;
  const Point middle = middle_of(kernel);
  return StarCentre{middle, is_inner_star_centre(set, middle)};
}

}  // namespace minkref::inline motion
