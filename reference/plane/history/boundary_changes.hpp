// Finds changes of the boundary: different moving figures just below, at or just above a scale.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "reference/plane/history/edges_on_lines.hpp"
#include "reference/plane/kernel/box.hpp"

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

  /// None if the boundary below and above is one moving figure, which reaches the boundary at the
  /// scale. `below` and `above`: sub-edges that may contain the place without ending there, besides
  /// sub-edges that end and begin. Exact. O(sub-edges at the points of change, plus the given
  /// sub-edges, and O(log n) of these for each point).
  std::optional<BoundaryChange> at(std::uint32_t group, const BoundaryAtGroup& here,
                                   std::span<const std::uint32_t> below = {},
                                   std::span<const std::uint32_t> above = {});

 private:
  /// Sides that begin and end at a point, as directions; empty if the boundary goes straight on.
  using Sides = std::vector<std::uint32_t>;
  /// Sub-edges at each of their two tracks.
  std::span<const std::uint32_t> of_track(std::uint32_t track) const {
    return {of_track_.data() + first_[track], of_track_.data() + first_[track + 1]};
  }
  std::uint32_t side(std::uint32_t edge, bool leaves) const;
  Sides between(std::uint32_t track, std::uint32_t interval) const;
  Sides at_scale(std::span<const std::uint32_t> tracks, std::uint32_t point, std::uint32_t group,
                 const BoundaryAtGroup& here) const;
  bool is_place(std::span<const std::uint32_t> tracks, std::uint32_t point, std::uint32_t group,
                const BoundaryAtGroup& here) const;
  Box box_at(std::uint32_t sub_edge, double scale) const;
  void add_parents(std::uint32_t sub_edge, const Rational& scale, bool above,
                   std::span<const std::uint32_t> tracks, const Point& place,
                   std::vector<std::uint32_t>& parents);

  const BoundaryHistory& history_;
  EdgesOnLines lines_;
  std::vector<std::uint32_t> first_, of_track_;
  std::vector<std::array<double, 4>> in_doubles_;  ///< tracks: a, b
};

}  // namespace minkref::inline plane
