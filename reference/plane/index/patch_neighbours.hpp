// For each convolution edge the others whose patch may cut its own where the boundary can be.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/index/patch_cells.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

struct PatchNeighbours {
  std::vector<std::uint32_t> first, others;  ///< those of edge e: others[first[e] .. first[e + 1])
  PatchCells cells;                          ///< an edge without any is certainly inside
  std::uint64_t meeting = 0;                 ///< pairs that doubles let meet in the window
  std::uint64_t inside = 0;                  ///< of these, left out: they meet inside the sum only
};

/// Pairs that are left out certainly never meet within the window, or certainly meet in the sum of
/// the interiors only, at all scales: what they cut off from each other is inside. S-edges first.
/// In doubles; the same for any number of threads. O(N^2).
PatchNeighbours patch_neighbours(const InteriorTracks& tracks, InteriorSolids& solids,
                                 const std::vector<RationalEdge>& edges, const ScaleWindow& window,
                                 const BuildControl& control);

}  // namespace minkref::inline plane
