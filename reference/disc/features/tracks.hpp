// Lives of bridges: how the corners of P ⊕ ρD last from radius to radius (Behar & Lien 2012, Sec.
// 8.2).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// A longest path along the diagram with growing radius, through nodes where a single part arrives
/// from below, a single part leaves upwards, and no part is flat. Each bridge has a single track.
struct BridgeTrack {
  /// Halves that rise, from the nearest part to the farthest.
  std::vector<std::uint32_t> halves;
};

/// Sorts the tracks by their lower nodes, radius first. Between two events' radii, the boundary of
/// P ⊕ ρD has as many corners as tracks exist. O(n log n).
std::vector<BridgeTrack> bridge_tracks(const DiscIndex& index);

}  // namespace minkref::inline disc
