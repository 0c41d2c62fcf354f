// The links of a moving boundary in ring order, for stretches of scales.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/index/moving_boundary.hpp"

namespace minkref::inline plane {

/// A link with its intervals, at its place within its ring.
struct RingEntry {
  std::uint32_t link = 0;
  std::uint32_t first = 0, last = 0;  ///< intervals
};

/// The features that a ring bounds, with the topology timeline's numbers.
struct RingFeatures {
  bool is_hole = false;         ///< clockwise
  std::uint32_t hole = 0;       ///< on its right; 0 is the outside
  std::uint32_t component = 0;  ///< on its left
};

/// Rings of the boundary over consecutive intervals. The entries present during an interval, in
/// this order, form the interval's rings: a link that replaces others stands beside them.
struct RingBucket {
  std::uint32_t first = 0, last = 0;  ///< intervals
  std::vector<RingEntry> entries;
  std::vector<std::uint32_t> ring_ends;  ///< behind the last entry of each ring
  std::vector<RingFeatures> features;    ///< of each ring; see feature_timeline.hpp
};

/// The effect of an event on the rings.
struct RingChange {
  bool same_rings = false;     ///< none merges, splits, appears or vanishes; surely
  bool same_vertices = false;  ///< known of the same rings only
  std::int64_t more_vertices = 0;
};

struct RingOrder {
  std::vector<RingBucket> buckets;
  std::vector<RingChange> changes;  ///< of each event
};

/// Splits a boundary's walks along the components into simple rings where the boundary touches
/// itself (docs/definitions.md, "Canonical form"). O(links that begin and end), and O(all links) at
/// events with rings that merge, split or touch. Throws std::logic_error if the links do not close
/// to rings: an independent check of the swept boundary.
RingOrder ring_order(const SweptBoundary& swept, const MovingBoundary& boundary,
                     const EdgeDirections& directions, const BuildControl& control);

}  // namespace minkref::inline plane
