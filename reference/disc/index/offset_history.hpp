// Holes and components of P ⊕ ρD from radius to radius: births, joins and ends.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// A hole that exists for birth <= radius < end. Radius numbers start from 1, as for DiscIndex; a
/// hole of P has birth 0.
struct OffsetHole {
  std::uint32_t birth, end;
  std::uint32_t born_at, ends_at;  ///< events; no first one of a hole of P
  std::uint32_t from;              ///< the hole that it was a part of; 0: of the outside, or of P
};

/// Two polygons of P that share a component from a radius on.
struct ComponentJoin {
  std::uint32_t radius;  ///< 0 where they touch
  std::uint32_t a, b;    ///< polygons
  std::uint32_t event;   ///< none where they touch
  bool at_radius;        ///< at the radius itself too: they face each other there
};

/// If the sum's complement falls apart as the radius grows, the part whose hole ends last keeps the
/// name; the outside has the name 0, and never ends. So each greatest value of the distance from P
/// ends one hole (the elder rule). If two holes end at one radius, the hole whose last event comes
/// first among the events keeps the name.
struct OffsetHistory {
  std::vector<OffsetHole> all_holes;  ///< from 1 on, by birth, then by end, the last first
  std::vector<ComponentJoin> joins;   ///< ascending
  std::uint32_t polygons;

  std::uint32_t holes(const DiscIndex::Place& at) const;
  std::uint32_t components(const DiscIndex::Place& at) const;
};

/// Exact. O(n log n).
OffsetHistory offset_history(const DiscIndex& index);

}  // namespace minkref::inline disc
