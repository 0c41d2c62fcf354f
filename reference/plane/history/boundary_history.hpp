// The sum's boundary through a window of scales, however found.
#pragma once

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/history/boundary_cycles.hpp"
#include "reference/plane/moving/track.hpp"

namespace minkref::inline plane {

/// A directed straight piece of the boundary, the sum on its left, for consecutive intervals.
struct MovingLink {
  std::uint32_t from = 0, to = 0;     ///< tracks
  std::uint32_t edge = 0;             ///< of the convolution; an edge along the link
  std::uint32_t first = 0, last = 0;  ///< intervals of scales, both included
};

/// Boundary links between points; a point is a track, or several tracks that coincide.
struct BoundaryState {
  std::vector<BoundaryLink> links;  ///< `before` and `after`: sub-edges, or no_sub_edge
};

/// The boundary at the scale of a group, as far as it differs from the sub-edges that go on.
struct BoundaryAtGroup {
  /// Coincident tracks, each with the least of them as their representative; sorted.
  /// Representatives are left out.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> merged;
  /// Pieces between representative tracks: parts of sub-edges that begin, end or are interrupted.
  std::vector<BoundaryLink> pieces;
  std::vector<std::uint32_t> interrupted;  ///< sub-edges that go on, in pieces here; sorted

  std::uint32_t standing_for(std::uint32_t track) const;
  bool is_interrupted(std::uint32_t sub_edge) const;
};

/// A scale at which the boundary is not the same moving figure just below, at and just above
/// (docs/definitions.md, "Boundary events").
struct BoundaryEvent {
  enum class Change : std::uint8_t {
    birth,  ///< more vertices above than below
    death,  ///< fewer
    swap,   ///< as many, others
    touch   ///< the same, in the same order: only the boundary at the scale is another
  };
  std::uint32_t group = 0;
  Change change = Change::birth;
  std::vector<std::uint32_t> edges;  ///< parents: convolution edges along it at its places
  Point place;                       ///< the least of its places
};

/// Sub-edges, each between two tracks for some intervals of scales in a row. Scales at which
/// something may change are groups, numbered from 0; interval k lies between groups k - 1 and k.
class BoundaryHistory {
 public:
  virtual ~BoundaryHistory() = default;

  virtual const std::vector<Track>& tracks() const = 0;
  virtual const std::vector<RationalEdge>& moving() const = 0;  ///< the convolution's edges
  virtual const EdgeDirections& directions() const = 0;         ///< of those edges
  /// Open.
  virtual const ScaleWindow& window() const = 0;
  virtual std::uint32_t group_count() const = 0;
  virtual Rational scale(std::uint32_t group) const = 0;

  /// Groups at which a sub-edge begins, ends, or is touched; ascending.
  virtual const std::vector<std::uint32_t>& groups() const = 0;
  virtual const std::vector<MovingLink>& sub_edges() const = 0;
  virtual BoundaryAtGroup at_group(std::uint32_t group) const = 0;

  std::vector<std::uint32_t> sub_edges_in(std::uint32_t interval) const;
  /// Sub-edges that begin or end with an interval.
  const std::vector<std::uint32_t>& begin_with(std::uint32_t interval) const;
  const std::vector<std::uint32_t>& end_with(std::uint32_t interval) const;

  /// An interval's state with these sub-edges, duplicates included.
  BoundaryState between(const std::vector<std::uint32_t>& sub_edges) const;
  /// The state at a group's scale, from the sub-edges of the preceding interval, duplicates
  /// included.
  BoundaryState at(std::uint32_t group, const BoundaryAtGroup& here,
                   const std::vector<std::uint32_t>& sub_edges) const;

  /// Groups that surely leave holes and components unchanged: facts known without the whole
  /// boundary. `change`: none if the vertices stay as well.
  struct Quiet {
    std::optional<BoundaryEvent::Change> change;
  };
  virtual std::optional<Quiet> quiet(std::uint32_t) const { return std::nullopt; }
  /// A number shared only by sub-edges that bound the same hole and component during an interval;
  /// quiet groups do not change it. Asked only if quiet groups exist.
  virtual std::uint32_t ring_of(std::uint32_t sub_edge, std::uint32_t /*interval*/) const {
    return sub_edge;
  }

 protected:
  /// Call once the sub-edges exist, before any other question.
  void sort_by_interval();

 private:
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> begin_, end_;  ///< by interval
};

}  // namespace minkref::inline plane
