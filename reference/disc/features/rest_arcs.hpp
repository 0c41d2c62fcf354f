// Arcs around rest material: about each feature corner runs an arc between both feet, without the
// parts inside discs about further corners.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "reference/disc/features/region_outlines.hpp"
#include "reference/number/radicals/surd.hpp"

namespace minkref::inline disc {

/// Corners with circles through an arc's end; none at a foot.
struct ArcEnd {
  std::vector<std::uint32_t> with = {};
  std::uint32_t vertex = DiagramGraph::none;  ///< shared with the first circle
  bool only_touches = false;                  ///< the first

  bool is_foot() const { return with.empty(); }
};

/// A part of a corner's circle, counter-clockwise, behind the bridge.
struct FreeArc {
  std::uint32_t corner;
  ArcEnd from, to;
};

/// Where the circle about a, counter-clockwise, enters the disc about b, or leaves; from a. Both
/// radii are equal, and more than half the distance.
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

/// The end for an arc about a, from a. Circles through a vertex meet again at the mirror image.
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

  /// Finds the free arcs about a feature's corners. Exact: doubles, then roots, also for touching
  /// circles and for three circles through a point. O(n^2)
  /// comparisons of doubles for n corners.
  std::vector<FreeArc> of(const std::vector<std::uint32_t>& corners);

  /// Corners whose open discs overlap behind both bridges, as found so far.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& overlaps() const { return overlaps_; }

 private:
  /// An arc's part inside a further corner's disc.
  struct Cover {
    std::uint32_t other;
    bool from_foot, to_foot, only_touches;
    std::uint32_t vertex;  ///< a shared foot, or none

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
  std::vector<Vector<Interval>> rounded_;           ///< centres
  std::vector<std::optional<Vector<Surd>>> exact_;  ///< centres, on demand
  std::vector<std::vector<std::uint32_t>>
      touched_;                       ///< for each corner: vertices on the circle, sorted
  std::vector<std::uint32_t> upper_;  ///< for each corner: the event there, or none
  std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps_;
};

}  // namespace minkref::inline disc
