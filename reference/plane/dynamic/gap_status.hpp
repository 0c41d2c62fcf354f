// The gaps between neighbours on a swept edge: inside the sum, or on its boundary.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/plane/dynamic/edge_history.hpp"

namespace minkref::inline plane {

/// A sub-edge's place relative to the sum: `tight` if only the interiors' sum misses the sub-edge.
enum class Status : std::uint8_t { interior, boundary, tight };

/// A piece of positive length at a group's scale, within one gap before and one after.
struct Stretch {
  std::uint32_t from, to;     ///< nodes by their local numbers
  std::size_t before, after;  ///< gaps
  bool overlapped;            ///< by a parallel edge, at this scale only
  std::size_t from_index;     ///< of `from`, in the list at the scale
  bool goes_on = false;       ///< as all of a sub-edge
};

/// A swept edge passes a group of events.
struct EdgePassage {
  std::uint32_t group, next;                      ///< the next group on this edge
  std::span<const std::uint32_t> list;            ///< the edge's start, nodes and end, above
  std::span<const Stretch> stretches;             ///< in order; at least one
  std::span<const Status> old_status;             ///< of the gaps below
  const std::vector<std::uint32_t>& overlapping;  ///< edges that share the line at the group only
};

/// Decides the gaps of one edge at a time, from below to above. A gap without length is `interior`.
class GapStatus {
 public:
  virtual ~GapStatus() = default;
  /// The loaded edge's gaps in interval 0; `next`: the first group on the edge.
  virtual void begin(std::span<const std::uint32_t> list, std::uint32_t next,
                     std::vector<Status>& status) = 0;
  /// The gaps above a group.
  virtual void pass(const EdgePassage& passage, std::vector<Status>& status) = 0;
  /// Whether an overlapped stretch lies on the boundary at the scale of the last passage.
  virtual bool on_boundary_at(const Stretch& stretch, const EdgePassage& passage) = 0;
  /// Appends its own records about the edge.
  virtual void finish(EdgeHistory& history) = 0;
};

}  // namespace minkref::inline plane
