// Which part of an offset curve is nearer to an edge of P than the radius.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/offset_patch.hpp"
#include "reference/number/radicals/root_number.hpp"

namespace minkref::inline disc {

struct RootPoint {
  RootNumber x, y;
};

/// The points of a patch in order: of an edge by how far along it they are, of an arc by the way
/// along a direction that grows with the angle.
class PatchPlace {
 public:
  enum class At : std::uint8_t { before, start, inside, end, beyond };

  PatchPlace(At at) : at_(at) {}  // NOLINT: implicit
  PatchPlace(RootNumber key, RootPoint point)
      : at_(At::inside), key_(std::move(key)), point_(std::move(point)), near_(key_.enclosure()) {}

  At at() const { return at_; }
  /// Of a place inside.
  const RootNumber& key() const { return key_; }
  const RootPoint& point() const { return point_; }
  /// The sign of the way from the other place to this one. Exact.
  int compare(const PatchPlace& other) const;

 private:
  At at_;
  RootNumber key_;
  RootPoint point_;
  Interval near_;
};

/// An open interval of a patch: the points nearer than the radius to one edge. What else is at the
/// distance of the radius at its ends, by features, where these are on the patch.
struct BlockedPart {
  PatchPlace low, high;
  std::vector<std::uint32_t> low_features, high_features;
};

/// The patches of a polygon set at one radius.
class PatchesAt {
 public:
  /// `squared_radius` > 0. `curves` must outlive it.
  PatchesAt(const OffsetCurves& curves, const Rational& squared_radius);

  /// The points at the distance of the radius from a convex set that are nearer to it are one
  /// interval of a line, and one of an arc as well: if a point of the edge blocks a direction it
  /// blocks those about its own, and the points of the edge that are near enough are an interval.
  /// It may run over the start of a patch and over its end, and leave out a part between: then it
  /// is two.
  std::vector<BlockedPart> blocked(std::size_t patch, const OffsetEdge& by) const;

  /// Of the start or end of a patch, or inside of it: in coordinates.
  RootPoint point(std::size_t patch, const PatchPlace& place) const;

  /// Which of two patches that start at a point comes first, clockwise from the way on which
  /// another one comes there. Exact.
  bool turns_before(std::size_t from, const RootPoint& at, std::size_t a, std::size_t b) const;

 private:
  struct Crossing;
  void add_circle_crossings(const OffsetPatch& patch, const OffsetEdge& by, bool at_end,
                            std::vector<Crossing>& found) const;
  void add_line_crossings(const OffsetPatch& patch, const OffsetEdge& by, int side,
                          std::vector<Crossing>& found) const;
  std::optional<BlockedPart> ridge(const OffsetPatch& patch, const OffsetEdge& by) const;
  int inside_at(const OffsetPatch& patch, const OffsetEdge& by, int end) const;
  RootPoint joint(const OffsetPatch& patch, int end) const;
  RootPoint tangent(const OffsetPatch& patch, const RootPoint& at) const;
  RootNumber arc_bound(const OffsetPatch& patch, const Direction& normal) const;

  const OffsetCurves& curves_;
  Rational squared_radius_;
};

}  // namespace minkref::inline disc
