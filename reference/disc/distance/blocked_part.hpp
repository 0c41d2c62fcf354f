// Which part of an offset curve is nearer to an edge of P than the radius.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "reference/disc/curves/offset_patch.hpp"
#include "reference/disc/distance/patch_crossings.hpp"

namespace minkref::inline disc {

/// A point of a patch, by what blocks there. The points of a patch are in order: of an edge by how
/// far along it they are, of an arc by the way along a direction that grows with the angle.
struct PatchPlace {
  enum class At : std::uint8_t { before, start, inside, end, beyond };
  struct Exact {
    RootNumber key;
    RootPoint point;
  };

  PatchPlace(At place) : at(place) {}  // NOLINT: implicit

  At at;
  NearCurve curve = NearCurve::start;  ///< of the edge `by`
  std::int8_t way = 0;
  std::uint32_t by = UINT32_MAX, feature = UINT32_MAX;
  Interval near;              ///< the key of a place inside
  Vector<Interval> position;  ///< of a place inside
  mutable std::shared_ptr<const Exact> exact;
};

/// An open interval of a patch: the points nearer than the radius to one edge. A single point
/// inside, where the edge is right across and as far: all around is farther.
struct BlockedPart {
  PatchPlace low, high;
};

/// How often doubles told, and how often exact numbers had to.
struct OffsetCounts {
  std::uint64_t pairs = 0, exact_pairs = 0, exact_orders = 0;
  void add(const OffsetCounts& other) {
    pairs += other.pairs;
    exact_pairs += other.exact_pairs;
    exact_orders += other.exact_orders;
  }
};

/// The patches of a polygon set at one radius.
class PatchesAt {
 public:
  /// `squared_radius` > 0.
  PatchesAt(OffsetCurves curves, const Rational& squared_radius);

  /// The points at the distance of the radius from a convex set that are nearer to it are one
  /// interval of a line, and one of an arc as well: if a point of the edge blocks a direction it
  /// blocks those about its own, and the points of the edge that are near enough are an interval.
  /// It may run over the start of a patch and over its end, and leave out a part between: then it
  /// is two. Exact: by intervals of doubles, and where they do not tell by roots.
  std::vector<BlockedPart> blocked(std::uint32_t patch, std::uint32_t by,
                                   OffsetCounts& counts) const;

  /// The part of an edge's patch midway between the edge and another one that faces it; `blocked`
  /// takes this part for blocked. Nothing is nearer to either edge there. Exact.
  std::optional<BlockedPart> ridge(std::uint32_t patch, std::uint32_t by) const;

  /// The sign of the way from place b of a patch to place a. Exact.
  int compare(std::uint32_t patch, const PatchPlace& a, const PatchPlace& b,
              OffsetCounts& counts) const;

  /// The coordinates of a place that is on its patch.
  RootPoint point(std::uint32_t patch, const PatchPlace& place) const;
  Vector<Interval> position(std::uint32_t patch, const PatchPlace& place) const;
  /// The key of a point of an arc in a direction.
  Interval key_of_normal(std::uint32_t arc, const Direction& normal) const;
  RootNumber exact_key_of_normal(std::uint32_t arc, const Direction& normal) const;
  const PatchPlace::Exact& exact(std::uint32_t patch, const PatchPlace& place) const;

  /// Which of two patches that start at a point comes first, clockwise from the way on which
  /// another one comes there. Exact.
  bool turns_before(std::uint32_t from, const RootPoint& at, std::uint32_t a,
                    std::uint32_t b) const;

  const OffsetCurves& curves() const { return curves_; }
  const Rational& squared_radius() const { return squared_radius_; }
  const EdgeNumbers<Interval>& edge(std::uint32_t k) const { return edges_[k]; }
  Interval radius() const { return radius_; }

 private:
  template <class N>
  std::vector<Crossing<N>> crossings(std::uint32_t patch, std::uint32_t by) const;
  template <class N>
  std::vector<BlockedPart> blocked_in(std::uint32_t patch, std::uint32_t by) const;
  template <class N>
  PatchPlace place_of(std::uint32_t patch, std::uint32_t by, const Crossing<N>& crossing) const;
  template <class N>
  std::vector<BlockedPart> blocked_of_line(std::uint32_t patch, std::uint32_t by) const;
  template <class N>
  std::vector<BlockedPart> blocked_of_arc(std::uint32_t patch, std::uint32_t by) const;
  template <class N>
  std::pair<N, N> ends(std::uint32_t patch) const;
  template <class N>
  int distance_at(std::uint32_t patch, std::uint32_t by, int end) const;
  template <class N>
  Vector<N> joint(std::uint32_t patch, int end) const;
  std::uint32_t feature_of(const OffsetEdge& by, NearCurve curve) const;
  bool may_be_ridge(std::uint32_t patch, std::uint32_t by) const;
  RootPoint tangent(std::uint32_t patch, const RootPoint& at) const;

  OffsetCurves curves_;
  Rational squared_radius_;
  Interval near_squared_radius_, radius_;
  std::vector<EdgeNumbers<Interval>> edges_;
  std::vector<ArcNumbers<Interval>> arcs_;  ///< by patch, from the first arc on
  std::size_t first_arc_;
};

}  // namespace minkref::inline disc
