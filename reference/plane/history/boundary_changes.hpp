// Where the boundary is not the same moving figure just below, at and just above a scale.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "reference/plane/history/edges_on_lines.hpp"

namespace minkref::inline plane {

/// The places of a boundary event (docs/definitions.md, "Boundary events").
struct BoundaryChange {
  Point place;                       ///< the least of the places, by x, then y
  std::vector<std::uint32_t> edges;  ///< parents, ascending
};

/// Looks at the sides that come to a point, at the points where something may happen. Not for
/// several threads at once.
class BoundaryChanges {
 public:
  /// `history` must outlive it.
  explicit BoundaryChanges(const BoundaryHistory& history);

  /// None where the boundary below and above is one moving figure, and the boundary at the scale is
  /// where that has come to. `below` and `above`: sub-edges in which a place may lie without being
  /// an end of them, besides those that end and begin. Exact. O(sub-edges at the points where
  /// something happens), and those given.
  std::optional<BoundaryChange> at(std::uint32_t group, const BoundaryAtGroup& here,
                                   std::span<const std::uint32_t> below = {},
                                   std::span<const std::uint32_t> above = {});

 private:
  /// Sides that begin and end at a point, by their directions; nothing where the boundary goes
  /// straight on.
  using Sides = std::vector<std::uint32_t>;
  /// Sub-edges by the tracks that they join.
  std::span<const std::uint32_t> of_track(std::uint32_t track) const {
    return {of_track_.data() + first_[track], of_track_.data() + first_[track + 1]};
  }
  std::uint32_t side(std::uint32_t edge, bool leaves) const;
  Sides between(std::uint32_t track, std::uint32_t interval) const;
  Sides at_scale(std::span<const std::uint32_t> tracks, std::uint32_t point, std::uint32_t group,
                 const BoundaryAtGroup& here) const;
  bool is_place(std::span<const std::uint32_t> tracks, std::uint32_t point, std::uint32_t group,
                const BoundaryAtGroup& here) const;
  bool is_certainly_beside(const MovingLink& link, double scale, double x, double y) const;
  void add_parents(std::uint32_t sub_edge, const Rational& scale, bool above,
                   std::span<const std::uint32_t> tracks, const Point& place,
                   std::vector<std::uint32_t>& parents);

  const BoundaryHistory& history_;
  EdgesOnLines lines_;
  std::vector<std::uint32_t> first_, of_track_;
  std::vector<std::array<double, 4>> in_doubles_;  ///< tracks: a, b
};

}  // namespace minkref::inline plane
