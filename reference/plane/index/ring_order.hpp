// The links of a moving boundary in the order of the rings, for stretches of scales.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/index/moving_boundary.hpp"

namespace minkref::inline plane {

/// A link while it is there, in the place that it has in its ring.
struct RingEntry {
  std::uint32_t link = 0;
  std::uint32_t first = 0, last = 0;  ///< intervals
};

/// The features that a ring bounds, in the numbers of the topology timeline.
struct RingFeatures {
  bool is_hole = false;         ///< clockwise
  std::uint32_t hole = 0;       ///< on its right; 0 is the outside
  std::uint32_t component = 0;  ///< on its left
};

/// Rings of the boundary over some intervals in a row. At each of them the entries that are there,
/// in this order, are its rings: a link that takes the place of others stands beside them.
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

/// Where the boundary touches itself its walks along the components are split into simple rings
/// (docs/definitions.md, "Canonical form"). O(links that begin and end), and of all the rings where
/// some merge, split or touch. Throws std::logic_error if the links do not close to rings: a check
/// of the swept boundary by itself.
RingOrder ring_order(const SweptBoundary& swept, const MovingBoundary& boundary,
                     const EdgeDirections& directions, const BuildControl& control);

}  // namespace minkref::inline plane
