// Holes and components of P ⊕ ρD from radius to radius: when they are born, join and end.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/index/offset_index.hpp"

namespace minkref::inline disc {

/// A hole that exists for birth <= radius < end. Radii are numbered from 1 on, as in OffsetIndex; a
/// hole of P has birth 0.
struct OffsetHole {
  std::uint32_t birth, end;
  std::uint32_t born_at, ends_at;  ///< events; no first one of a hole of P
  std::uint32_t from;              ///< the hole that it was a part of; 0: of the outside, or of P
};

/// Polygons of P whose components are one from a radius on.
struct ComponentJoin {
  std::uint32_t radius;  ///< 0 where they touch
  std::uint32_t a, b;    ///< polygons
  std::uint32_t event;   ///< none where they touch
  bool at_radius;        ///< at the radius itself too: they face each other there
};

/// Where the complement of the sum falls apart as the radius grows, the part goes on under the name
/// of the hole that ends last; that of the outside is 0, and it never ends. So each greatest value
/// of the distance from P is the end of one hole (the elder rule). Where two end at one radius the
/// one whose last event comes first in the list goes on.
struct OffsetHistory {
  std::vector<OffsetHole> all_holes;  ///< from 1 on, by birth, then by end, the last first
  std::vector<ComponentJoin> joins;   ///< ascending
  std::uint32_t polygons;

  std::uint32_t holes(const OffsetIndex::Place& at) const;
  std::uint32_t components(const OffsetIndex::Place& at) const;
};

/// Exact. O(n log n).
OffsetHistory offset_history(const OffsetIndex& index);

}  // namespace minkref::inline disc
