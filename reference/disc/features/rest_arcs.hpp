// Arcs that bound the rest material: about each corner of a feature, the arc between both feet, as
// far as no disc about another corner covers it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/features/region_outlines.hpp"
#include "reference/number/radicals/surd.hpp"

namespace minkref::inline disc {

/// Corners whose circles cross or touch an arc at its end; none at a foot.
struct ArcEnd {
  std::vector<std::uint32_t> with = {};
  std::uint32_t vertex = DiagramGraph::none;  ///< on the circle of the first, too, and on the arc's
  bool only_touches = false;                  ///< the first

  bool is_foot() const { return with.empty(); }
};

/// A part of the circle about a corner, counter-clockwise, behind the corner's bridge.
struct FreeArc {
  std::uint32_t corner;
  ArcEnd from, to;
};

/// The point, from the centre a, at which the circle about a enters the disc about b, or leaves it,
/// running counter-clockwise. Both radii are equal, and more than half the distance.
template <class N>
Vector<N> crossing_from(const Vector<N>& a, const Vector<N>& b, const N& squared_radius,
                        const N& half, bool enters) {
  const Vector<N> way = b - a;
  const N far = sqrt(squared_radius / dot(way, way) - half * half);
  const Vector<N> middle = half * way, across = far * turned(way);
  return enters ? middle - across : middle + across;
}

inline Interval rational_like(const Rational& value, const Interval& /*like*/) {
  return Interval(value);
}
inline Surd rational_like(const Rational& value, const Surd& /*like*/) { return value; }
inline MpfrInterval rational_like(const Rational& value, const MpfrInterval& like) {
  return {value, like.precision()};
}

/// The end of an arc about a, from a. Circles through one vertex meet again in its mirror image.
template <class N>
Vector<N> arc_end(const OffsetCurves& curves, const ArcEnd& end, const Vector<N>& a,
                  const Vector<N>& b, const N& squared_radius, const N& half, bool at_start) {
  if (end.only_touches) return half * (b - a);
  if (end.vertex == DiagramGraph::none) {
    return crossing_from(a, b, squared_radius, half, !at_start);
  }
  const Point& vertex = curves.features[end.vertex].centre;
  return {b.x - rational_like(vertex.x, half), b.y - rational_like(vertex.y, half)};
}

class RestArcs {
 public:
  /// The outlines must outlive the object, at a finite radius.
  explicit RestArcs(const RegionOutlines& outlines);

  /// The free arcs about the corners of one feature, given by number. Exact: doubles, then
  /// roots; circles that touch, and circles that meet in one point, are told from others. O(n^2)
  /// comparisons of doubles for n corners.
  std::vector<FreeArc> of(const std::vector<std::uint32_t>& corners);

 private:
  /// The part of an arc inside the disc about another corner.
  struct Cover {
    std::uint32_t other;
    bool from_foot, to_foot, only_touches;
    std::uint32_t vertex;  ///< a foot of both; none

    ArcEnd end() const { return {{other}, vertex, only_touches}; }
  };

  template <class N>
  const Vector<N>& centre(std::uint32_t corner);
  template <class N>
  Vector<N> place(std::uint32_t corner, const Cover& cover, bool at_start);
  template <class Of>
  int decided(Of&& of);
  bool are_one_circle(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t shared_foot(std::uint32_t a, std::uint32_t b) const;
  bool is_vertex_foot(std::uint32_t corner, std::uint32_t vertex, bool at_start) const;
  std::optional<Cover> cover_of(std::uint32_t corner, std::uint32_t other);
  int order(std::uint32_t corner, const Cover& a, bool a_start, const Cover& b, bool b_start);
  void add_free(std::uint32_t corner, std::vector<Cover> covers, std::vector<FreeArc>& found);

  const RegionOutlines& outlines_;
  Rational squared_;
  std::vector<Vector<Interval>> rounded_;            ///< centres
  std::vector<std::optional<Vector<Surd>>> exact_;   ///< centres, on demand
  std::vector<std::vector<std::uint32_t>> touched_;  ///< by corner: vertices on the circle, sorted
  std::vector<std::uint32_t> upper_;  ///< by corner: the event at the corner, or none
};

}  // namespace minkref::inline disc
