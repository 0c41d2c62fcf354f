// The features at one radius, each with its bridges, and the reflex vertices to cut at.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/features/barcode.hpp"
#include "reference/disc/features/leaf_depth.hpp"

namespace minkref::inline disc {

struct LiveFeature {
  std::uint32_t node;                  ///< of the tree
  std::uint32_t bar;                   ///< number in the barcode
  std::vector<std::uint32_t> leaves;   ///< reflex ends, as tree nodes, ascending
  std::vector<std::uint32_t> bridges;  ///< halves that rise from it to the radius or beyond
};

/// The features alive at a place among the radii: birth < radius <= death. At gap 0 each reflex end
/// counts. Ascending by tree node. An ended hole has none. Exact. O(n).
std::vector<LiveFeature> features_at(const DiscIndex& index, const MergeTree& tree,
                                     const Barcode& codes, const DiscIndex::Place& at);

/// A feature's deepest reflex vertex.
struct PocketMinimum {
  std::uint32_t leaf;  ///< tree node
  LeafDepth depth;
  bool is_tie;  ///< the least place decided
};

/// None for a feature without reflex ends. `feature`, `bridges` and `radius` must outlive it. O(l
/// b) for l reflex ends and b bridges.
std::optional<PocketMinimum> pocket_minimum(const Bridges& bridges, const MergeTree& tree,
                                            const LiveFeature& feature, const BridgeRadius& radius);

}  // namespace minkref::inline disc
