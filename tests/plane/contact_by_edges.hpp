// The contact of two sets by definition: cuts the edges of each set at the other set's edges. No
// triangles and no convolution.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/plane/witness.hpp"
#include "tests/plane/ray_casting.hpp"

namespace minkref::testing {

struct Edge {
  Point from, to;
};

/// A point has none, a segment has one.
inline std::vector<Edge> edges(const PolygonSet& set) {
  std::vector<Edge> all;
  for_each_ring(set, [&](const Ring& ring) {
    if (ring.size() == 2) all.push_back({ring[0], ring[1]});
    if (ring.size() < 3) return;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      all.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  });
  return all;
}

/// Where the closed segment b meets the closed segment a, as parameters along a: none, one, or the
/// two ends of an overlap.
inline std::vector<Rational> meeting(const Edge& a, const Edge& b) {
  const Point d = a.to - a.from, e = b.to - b.from, w = b.from - a.from;
  const Rational denominator = cross(d, e);
  if (sign(denominator) != 0) {
    const Rational t = cross(w, e) / denominator, u = cross(w, d) / denominator;
    return t >= 0 && t <= 1 && u >= 0 && u <= 1 ? std::vector<Rational>{t}
                                                : std::vector<Rational>{};
  }
  if (sign(cross(w, d)) != 0) return {};
  Rational low = dot(w, d) / dot(d, d), high = dot(b.to - a.from, d) / dot(d, d);
  if (low > high) std::swap(low, high);
  low = std::max(low, Rational(0));
  high = std::min(high, Rational(1));
  if (low > high) return {};
  return low == high ? std::vector<Rational>{low} : std::vector<Rational>{low, high};
}

/// Whether a piece of A's boundary, between two meetings with B's boundary, runs through B's
/// interior, or along B's boundary with both interiors on one side. If so, the interiors overlap;
/// if neither A's pieces in B nor B's pieces in A do so, the interiors are disjoint: a non-empty
/// common interior has a boundary with such pieces. Sets `meets` if the boundaries share a point.
inline bool enters(const PolygonSet& A, const PolygonSet& B, bool sides_count, bool& meets) {
  const std::vector<Edge> of_b = edges(B);
  for (const Edge& a : edges(A)) {
    std::vector<Rational> cuts{0, 1};
    for (const Edge& b : of_b) {
      const std::vector<Rational> at = meeting(a, b);
      meets = meets || !at.empty();
      cuts.insert(cuts.end(), at.begin(), at.end());
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] == cuts[i + 1]) continue;
      const Point middle = a.from + Rational((cuts[i] + cuts[i + 1]) / 2) * (a.to - a.from);
      const Where place = where(B, middle);
      if (place == Where::inside) return true;
      if (place == Where::outside || !sides_count) continue;
      for (const Edge& b : of_b) {
        if (on_segment(middle, b.from, b.to) && sign(dot(a.to - a.from, b.to - b.from)) > 0) {
          return true;
        }
      }
    }
  }
  return false;
}

/// A point or a segment counts by its relative interior; at most one operand may be such a set.
inline Contact contact_by_edges(const PolygonSet& A, const PolygonSet& B) {
  if (A.empty() || B.empty()) return Contact::empty;
  if (!B.is_region()) return contact_by_edges(B, A);
  if (A.is_point()) {
    const Where place = where(B, A.polygons[0].outer[0]);
    return place == Where::inside     ? Contact::overlapping
           : place == Where::boundary ? Contact::touching
                                      : Contact::empty;
  }
  bool meets = false;
  if (enters(A, B, A.is_region(), meets)) return Contact::overlapping;
  if (A.is_region() && enters(B, A, true, meets)) return Contact::overlapping;
  return meets ? Contact::touching : Contact::empty;
}

/// The contact at x for membership in sP + Q.
inline Contact contact_at(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                          const Point& x) {
  return contact_by_edges(stretched(P, scale), placed(Q, x));
}

}  // namespace minkref::testing
