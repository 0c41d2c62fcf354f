#include "reference/plane/polygon_set.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"

namespace minkref::inline plane {

std::size_t PolygonSet::vertices() const {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
  }
  return count;
}

std::size_t PolygonSet::rings() const {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) count += 1 + polygon.holes.size();
  return count;
}

namespace {

/// The sum of fractions by halves: denominators grow as a product tree, not as a chain.
Rational pairwise_sum(std::vector<Rational>& terms, std::size_t begin, std::size_t end) {
  if (begin == end) return 0;
  if (end - begin == 1) return std::move(terms[begin]);
  look_for_interrupt();
  const std::size_t middle = begin + (end - begin) / 2;
  return pairwise_sum(terms, begin, middle) + pairwise_sum(terms, middle, end);
}

void add_cross_products(const Ring& ring, std::vector<Rational>& terms) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    look_for_interrupt();
    terms.push_back(a.x * b.y - a.y * b.x);
  }
}

template <class Change>
PolygonSet mapped(const PolygonSet& set, Change&& change) {
  PolygonSet result = set;
  const auto change_ring = [&](Ring& ring) {
    for (Point& p : ring) {
      look_for_interrupt();
      change(p);
    }
  };
  for (Polygon& polygon : result.polygons) {
    change_ring(polygon.outer);
    for (Ring& hole : polygon.holes) change_ring(hole);
  }
  return result;
}

}  // namespace

Rational doubled_area(const Ring& ring) {
  std::vector<Rational> terms;
  add_cross_products(ring, terms);
  return pairwise_sum(terms, 0, terms.size());
}

Rational area(const PolygonSet& set) {
  std::vector<Rational> terms;
  for (const Polygon& polygon : set.polygons) {
    add_cross_products(polygon.outer, terms);
    for (const Ring& hole : polygon.holes) add_cross_products(hole, terms);
  }
  return pairwise_sum(terms, 0, terms.size()) / 2;
}

void orient(PolygonSet& set) {
  for (Polygon& polygon : set.polygons) {
    if (sign(doubled_area(polygon.outer)) < 0)
      std::reverse(polygon.outer.begin(), polygon.outer.end());
    for (Ring& hole : polygon.holes) {
      if (sign(doubled_area(hole)) > 0) std::reverse(hole.begin(), hole.end());
    }
  }
}

PolygonSet scaled(const PolygonSet& set, const Rational& factor) {
  if (factor == 1) return set;
  return mapped(set, [&](Point& p) {
    p.x *= factor;
    p.y *= factor;
  });
}

PolygonSet translated(const PolygonSet& set, const Point& by) {
  return mapped(set, [&](Point& p) {
    p.x += by.x;
    p.y += by.y;
  });
}

}  // namespace minkref::inline plane
