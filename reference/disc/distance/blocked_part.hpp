// The part of an offset curve nearer to an edge of P than the radius.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "reference/disc/curves/offset_patch.hpp"
#include "reference/disc/distance/patch_crossings.hpp"

namespace minkref::inline disc {

/// A patch's point, named after the blocking curve. A patch's points are ordered: on an edge by the
/// distance along the edge, on an arc by the way along a direction, which grows with the angle.
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

/// An open interval of a patch: the points nearer to one edge than the radius. A single inner point
/// if the edge lies right across and exactly as far: everything around is farther.
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

/// A polygon set's patches at one radius.
class PatchesAt {
 public:
  /// `squared_radius` > 0.
  PatchesAt(OffsetCurves curves, const Rational& squared_radius);

  /// The parts of a patch nearer to the edge `by` than the radius. These points form one interval
  /// on a line, as the edge is convex, and on an arc too: an edge point that blocks a direction
  /// blocks all directions about its own, and the near enough edge points form an interval. The
  /// interval may run over both the patch's start and its end, and leave out a part between: then
  /// the result has two parts. Exact: by intervals of doubles or, if they do not tell, by roots.
  std::vector<BlockedPart> blocked(std::uint32_t patch, std::uint32_t by,
                                   OffsetCounts& counts) const;

  /// The part of an edge's patch midway between the edge and another facing edge; `blocked` takes
  /// this part for blocked. Nothing lies nearer to either edge. Exact.
  std::optional<BlockedPart> ridge(std::uint32_t patch, std::uint32_t by) const;

  /// The sign of the way from place b of a patch to place a. Exact.
  int compare(std::uint32_t patch, const PatchPlace& a, const PatchPlace& b,
              OffsetCounts& counts) const;

  /// The coordinates of a place on a patch.
  RootPoint point(std::uint32_t patch, const PatchPlace& place) const;
  Vector<Interval> position(std::uint32_t patch, const PatchPlace& place) const;
  /// The key of an arc's point along a normal.
  Interval key_of_normal(std::uint32_t arc, const Direction& normal) const;
  RootNumber exact_key_of_normal(std::uint32_t arc, const Direction& normal) const;
  const PatchPlace::Exact& exact(std::uint32_t patch, const PatchPlace& place) const;

  /// Whether patch a comes before patch b, both starting at a point, clockwise from the way on
  /// which patch `from` arrives. Exact.
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
