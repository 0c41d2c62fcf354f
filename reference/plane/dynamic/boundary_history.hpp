// The boundary of the sum through a window of scales, whichever way it was found.
#pragma once

#include <optional>
#include <vector>

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/dynamic/boundary_cycles.hpp"
#include "reference/plane/dynamic/edge_history.hpp"
#include "reference/plane/dynamic/node_track.hpp"

namespace minkref {

/// Boundary links between points; a point is a track, or several tracks that coincide.
struct BoundaryState {
  std::vector<BoundaryLink> links;  ///< `before` and `after`: sub-edges, or no_sub_edge
};

/// A scale at which the vertices of the boundary or their order change.
struct BoundaryEvent {
  enum class Change : std::uint8_t {
    birth,  ///< there are more vertices above than below
    death,  ///< fewer
    swap,   ///< as many, others
    touch   ///< the same: the boundary touches itself at this scale only
  };
  std::uint32_t group = 0;
  Change change = Change::birth;
  std::vector<std::uint32_t> edges;  ///< convolution edges through the places where it changes
  Point place;                       ///< one of those places
};

/// Sub-edges, each between two tracks for some intervals of scales in a row. Scales at which
/// something may change are groups, numbered from 0; interval k lies between groups k - 1 and k.
class BoundaryHistory {
 public:
  virtual ~BoundaryHistory() = default;

  virtual const std::vector<Track>& tracks() const = 0;
  virtual const std::vector<RationalEdge>& moving() const = 0;  ///< the convolution's edges
  /// Open.
  virtual const ScaleWindow& window() const = 0;
  virtual std::uint32_t group_count() const = 0;
  virtual Rational scale(std::uint32_t group) const = 0;

  /// Groups at which a sub-edge begins, ends, or is touched; ascending.
  virtual const std::vector<std::uint32_t>& groups() const = 0;
  virtual std::size_t sub_edge_count() const = 0;
  virtual std::vector<std::uint32_t> sub_edges_in(std::uint32_t interval) const = 0;
  /// Sub-edges that begin with an interval, and those that end with it.
  virtual const std::vector<std::uint32_t>& begin_with(std::uint32_t interval) const = 0;
  virtual const std::vector<std::uint32_t>& end_with(std::uint32_t interval) const = 0;

  /// Of an interval with these sub-edges. Duplicates included.
  virtual BoundaryState between(const std::vector<std::uint32_t>& sub_edges) const = 0;
  /// At the scale of a group, from the sub-edges of the interval before it. Duplicates included.
  virtual BoundaryState at_group(std::uint32_t group,
                                 const std::vector<std::uint32_t>& sub_edges) const = 0;

  /// Convolution edges through the places where something happens at a group, ascending.
  virtual std::vector<std::uint32_t> edges_at(std::uint32_t group) const = 0;
  /// Such a place, if one is known.
  virtual std::optional<Point> place_at(std::uint32_t group) const = 0;

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
};

}  // namespace minkref
