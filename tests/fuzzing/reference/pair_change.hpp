// Changes one operand with regard to the other. The result may be invalid; the mutator checks.
#pragma once

#include <span>

#include "reference/plane/polygon_set.hpp"
#include "tests/fuzzing/reference/dice.hpp"

namespace minkref::fuzzing {

/// The operands that a change works on. `other` is scaled like `shape`: shapes that fit here fit at
/// the pair's scale.
struct ChangeSite {
  Dice& dice;
  PolygonSet& shape;
  const PolygonSet& other;

  /// A random ring; the set has at least one.
  Ring& some_ring(PolygonSet& set) const;
  const Ring& some_ring(const PolygonSet& set) const;
  /// A vertex of either operand, or two vertices' sum or difference: the points of a convolution.
  Point some_point() const;
  /// Two consecutive vertices.
  std::pair<Point, Point> some_edge(const PolygonSet& set) const;
};

using ChangeOf = void (*)(const ChangeSite&);

/// Single vertices and coordinates (vertex_changes.cpp).
std::span<const ChangeOf> vertex_changes();
/// Whole rings and polygons (ring_changes.cpp).
std::span<const ChangeOf> ring_changes();
/// The whole operand: translated, stretched, sheared, mirrored (operand_changes.cpp).
std::span<const ChangeOf> operand_changes();
/// Fewer vertices, rings, digits; for minimising, and against growth (simpler_changes.cpp).
std::span<const ChangeOf> simpler_changes();

/// Applies a map to every point.
template <class Map>
void map_points(PolygonSet& set, const Map& map) {
  for (Polygon& polygon : set.polygons) {
    for (Point& p : polygon.outer) p = map(p);
    for (Ring& hole : polygon.holes) {
      for (Point& p : hole) p = map(p);
    }
  }
}

inline Point operator+(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }
inline Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
inline Point operator*(const Rational& factor, const Point& p) {
  return {factor * p.x, factor * p.y};
}
inline Rational larger(const Rational& x, const Rational& y) { return x < y ? y : x; }
/// The box's longer side.
inline Rational reach(const Point& d) { return larger(abs(d.x), abs(d.y)); }

}  // namespace minkref::fuzzing
