// The boundary of the sum through a window of scales, whichever way it was found.
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

/// A directed straight piece of the boundary, the sum on its left, for some intervals in a row.
struct MovingLink {
  std::uint32_t from = 0, to = 0;     ///< tracks
  std::uint32_t edge = 0;             ///< of the convolution; one of those that it is on
  std::uint32_t first = 0, last = 0;  ///< intervals of scales, both included
};

/// Boundary links between points; a point is a track, or several tracks that coincide.
struct BoundaryState {
  std::vector<BoundaryLink> links;  ///< `before` and `after`: sub-edges, or no_sub_edge
};

/// The boundary at the scale of a group, as far as it differs from the sub-edges that go on.
struct BoundaryAtGroup {
  /// Tracks that are at one point, each with the least of them, which stands for it; sorted. Those
  /// that stand for themselves are left out.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> merged;
  /// Between tracks that stand for their points: parts of sub-edges that begin, end or are
  /// interrupted.
  std::vector<BoundaryLink> pieces;
  std::vector<std::uint32_t> interrupted;  ///< sub-edges that go on, in pieces here; sorted

  std::uint32_t standing_for(std::uint32_t track) const;
  bool is_interrupted(std::uint32_t sub_edge) const;
};

/// A scale at which the boundary is not the same moving figure just below, at and just above
/// (docs/definitions.md, "Boundary events").
struct BoundaryEvent {
  enum class Change : std::uint8_t {
    birth,  ///< there are more vertices above than below
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
  /// Sub-edges that begin with an interval, and those that end with it.
  const std::vector<std::uint32_t>& begin_with(std::uint32_t interval) const;
  const std::vector<std::uint32_t>& end_with(std::uint32_t interval) const;

  /// The state in an interval with these sub-edges. Duplicates included.
  BoundaryState between(const std::vector<std::uint32_t>& sub_edges) const;
  /// At the scale of a group, from the sub-edges of the interval before it. Duplicates included.
  BoundaryState at(std::uint32_t group, const BoundaryAtGroup& here,
                   const std::vector<std::uint32_t>& sub_edges) const;

  /// Groups that surely leave holes and components as they are: what is known of them without a
  /// look at the whole boundary. `change`: none where the vertices stay as well.
  struct Quiet {
    std::optional<BoundaryEvent::Change> change;
  };
  virtual std::optional<Quiet> quiet(std::uint32_t) const { return std::nullopt; }
  /// A number that only sub-edges share that bound the same hole and component in an interval; it
  /// stays theirs across quiet groups. Asked for only where there are such groups.
  virtual std::uint32_t ring_of(std::uint32_t sub_edge, std::uint32_t /*interval*/) const {
    return sub_edge;
  }

 protected:
  /// Once the sub-edges are there, before anything else is asked.
  void sort_by_interval();

 private:
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> begin_, end_;  ///< by interval
};

}  // namespace minkref::inline plane
