// Lives of bridges: how the corners of P ⊕ ρD last from radius to radius (Behar & Lien 2012, Sec.
// 8.2).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// A longest path along the diagram on which the radius grows, through nodes at which one part
/// arrives from below, one leaves upwards, and no part is flat. Each bridge belongs to one track.
struct BridgeTrack {
  /// Halves that rise, from the nearest part to the farthest.
  std::vector<std::uint32_t> halves;
};

/// The tracks, by the radius, then by the number, of the node from which they rise. Between two
/// radii of events, as many tracks exist as the boundary of P ⊕ ρD has corners. O(n log n).
std::vector<BridgeTrack> bridge_tracks(const DiscIndex& index);

}  // namespace minkref::inline disc
