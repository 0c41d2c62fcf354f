// For each convolution edge the other edges whose patch may cut its own at possible
// boundary places.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/critical/pair_events.hpp"
#include "reference/plane/index/patch_cells.hpp"
#include "reference/plane/moving/moving_edge.hpp"

namespace minkref::inline plane {

struct PatchNeighbours {
  std::vector<std::uint32_t> first, others;  ///< edge e has others[first[e] .. first[e + 1])
  PatchCells cells;                          ///< an edge without any is certainly inside
  std::uint64_t meeting = 0;                 ///< pairs that doubles let meet in the window
  std::uint64_t inside = 0;                  ///< of these, left out: meet inside the sum only
  std::uint64_t looked_at = 0;               ///< pairs that boxes did not tell apart
};

/// Omitted pairs certainly never meet within the window, or certainly meet inside the interiors'
/// sum only, at all scales: the parts that they cut off from each other lie inside. S-edges first.
/// By doubles; the same for any number of threads. O(N log N) and the pairs within blocks whose
/// boxes meet; O(N^2) at worst.
///
/// `kept`, if not empty: leaves out pairs between kept edges, and all pairs with edges `inside`.
enum class Kept : char { no, live, inside };
PatchNeighbours patch_neighbours(const InteriorTracks& tracks, InteriorSolids& solids,
                                 const std::vector<RationalEdge>& edges, const ScaleWindow& window,
                                 const BuildControl& control, const std::vector<Kept>& kept = {});

}  // namespace minkref::inline plane
