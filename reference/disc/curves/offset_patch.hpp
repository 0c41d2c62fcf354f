// The offset curves of a polygon set or of lines: edges moved outwards by the radius, and arcs
// about vertices.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "reference/number/rational.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline disc {

/// A vector of rationals.
struct Direction {
  Rational x, y;
};

inline Rational dot(const Direction& a, const Direction& b) { return a.x * b.x + a.y * b.y; }
inline Rational cross(const Direction& a, const Direction& b) { return a.x * b.y - a.y * b.x; }
/// Turned by a quarter turn, counter-clockwise.
inline Direction turned(const Direction& a) { return {-a.y, a.x}; }
inline Direction from_to(const Point& from, const Point& to) {
  return {to.x - from.x, to.y - from.y};
}

/// Whether x comes before y, counter-clockwise from a direction, which itself comes last.
bool comes_before(const Direction& from, const Direction& x, const Direction& y);

/// The first edge from `leaving` outside P, counter-clockwise from the way back along an edge that
/// ends at the common vertex (`in`: the ending edge's direction). `along`: the directions of
/// `leaving`.
template <class Along>
std::uint32_t next_outside(const Direction& in, const std::vector<std::uint32_t>& leaving,
                           Along&& along) {
  const Direction back{-in.x, -in.y};
  return *std::min_element(leaving.begin(), leaving.end(), [&](std::uint32_t a, std::uint32_t b) {
    return comes_before(back, along(a), along(b));
  });
}

/// Coprime integers along d; d must not be zero.
Direction primitive(const Direction& d);

/// A closed edge of P. The offset curve is part of a line.
struct OffsetEdge {
  VertexId id;            ///< where it starts
  std::uint32_t polygon;  ///< its number in P
  Point start, end;
  Direction along, normal;  ///< the normal points outwards and is as long as the edge
  Rational squared_length;
  std::uint32_t feature;                     ///< of its line: edges on one line have one
  std::uint32_t start_feature, end_feature;  ///< of the circles about its ends
};

/// A part of an offset curve, with P on the left: from one edge, or an arc of at most a right
/// angle.
struct OffsetPatch {
  static constexpr std::uint32_t none = UINT32_MAX;

  std::uint32_t feature;
  std::uint32_t polygon;  ///< one of those that it is about
  std::uint32_t edge;     ///< its number; none for an arc
  Point centre;           ///< of an arc
  Direction first, last;  ///< of an arc: directions of the normals at its ends
  std::uint32_t next;     ///< the patch that starts where this one ends; none at a reflex vertex
};

struct OffsetCurves {
  std::vector<OffsetEdge> edges;
  std::vector<OffsetPatch> patches;
  struct Feature {
    std::uint32_t edge;  ///< the first on a line; none for a circle
    Point centre;
    bool has_arc;  ///< a circle with some
  };
  std::vector<Feature> features;  ///< vertices in one place are one
  /// A vertex of P inside an edge, which goes straight on there. Sorted by edge, then along the
  /// edge.
  struct StraightVertex {
    std::uint32_t edge;
    VertexId id;
    Point at;
  };
  std::vector<StraightVertex> straight;
};

/// The offset curves of a valid polygon set, or of points and segments, which have curves on both
/// sides. Edges go on through straight vertices. O(n log n).
OffsetCurves offset_curves(const PolygonSet& P);

}  // namespace minkref::inline disc
