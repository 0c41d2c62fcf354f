// The operand and the result: closed regular sets in the plane bounded by polygons, exact
// coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "reference/number/rational.hpp"

namespace minkref::inline plane {

struct Point {
  Rational x, y;
  friend bool operator==(const Point&, const Point&) = default;
};

using Ring = std::vector<Point>;

/// One outer ring (counter-clockwise) and its holes (clockwise). Rings may touch at single points.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// A set of polygons with disjoint interiors. Degenerate operands have the same form: the empty set
/// (no polygon), a point (one outer ring with one vertex), a segment (with two vertices), and open
/// lines (several of these; lines.hpp tells them from regions, `is_region` does not).
struct PolygonSet {
  std::vector<Polygon> polygons;

  bool empty() const { return polygons.empty(); }
  bool is_point() const { return polygons.size() == 1 && polygons[0].outer.size() == 1; }
  bool is_segment() const { return polygons.size() == 1 && polygons[0].outer.size() == 2; }
  bool is_region() const { return !empty() && !is_point() && !is_segment(); }
  std::size_t vertices() const;  ///< over all rings
  std::size_t rings() const;
  friend bool operator==(const PolygonSet&, const PolygonSet&) = default;
};

/// A vertex of an operand: ring number (outer, holes, outer, holes, ...) and index within the ring.
struct VertexId {
  std::uint32_t ring = 0, index = 0;
  friend bool operator==(const VertexId&, const VertexId&) = default;
};

/// Refuses sets that are not regular closed (docs/definitions.md, "Polygon set"). Ring numbers
/// follow the order outer, holes, outer, holes, ... Throws BadInput that names ring, vertices and
/// coordinates. Codes: "too-few-vertices", "zero-length-edge", "zero-area", "wrong-orientation",
/// "self-intersection", "overlapping-rings", "crossing-rings", "hole-outside",
/// "overlapping-polygons". Exact. O((n + k) log n) on usual input.
void validate(const PolygonSet& set);

/// Turns every ring as its role demands (outer rings counter-clockwise, holes clockwise). Exact.
/// Rings of zero area stay unchanged.
void orient(PolygonSet& set);

/// Twice the signed area of a ring. Exact.
Rational doubled_area(const Ring& ring);

/// The area of the set (outer rings less holes). Exact.
Rational area(const PolygonSet& set);

PolygonSet scaled(const PolygonSet& set, const Rational& factor);
PolygonSet translated(const PolygonSet& set, const Point& by);

}  // namespace minkref::inline plane
