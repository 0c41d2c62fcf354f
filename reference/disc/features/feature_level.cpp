#include "reference/disc/features/feature_level.hpp"

#include <algorithm>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline disc {

std::vector<LiveFeature> features_at(const DiscIndex& index, const MergeTree& tree,
                                     const Barcode& codes, const DiscIndex::Place& at) {
  constexpr std::uint32_t none = MergeTree::none;
  const std::uint32_t below = at.at_event ? at.gap - 1 : at.gap;
  // Each tree node's live feature; parents come after their children.
  std::vector<std::uint32_t> live(tree.nodes.size(), none);
  std::vector<LiveFeature> found;
  for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
    const MergeNode& own = tree.nodes[node];
    if (own.radius > below || own.parent == none) continue;
    if (tree.nodes[own.parent].radius <= below) continue;
    live[node] = static_cast<std::uint32_t>(found.size());
    found.push_back({node, codes.bar_of[node], {}, {}});
  }
  for (auto node = static_cast<std::uint32_t>(tree.nodes.size()); node-- > 0;) {
    const std::uint32_t parent = tree.nodes[node].parent;
    if (parent != none && live[node] == none) live[node] = live[parent];
  }
  for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
    look_for_interrupt();
    if (live[node] == none || tree.nodes[node].radius > below) continue;
    LiveFeature& feature = found[live[node]];
    if (tree.is_reflex(node)) feature.leaves.push_back(node);
    for (const std::uint32_t half : tree.rising[node]) {
      if (index.low(half) <= below && below < index.high(half)) feature.bridges.push_back(half);
    }
  }
  return found;
}

std::optional<PocketMinimum> pocket_minimum(const Bridges& bridges, const MergeTree& tree,
                                            const LiveFeature& feature,
                                            const BridgeRadius& radius) {
  std::optional<PocketMinimum> found;
  for (const std::uint32_t leaf : feature.leaves) {
    LeafDepth depth(bridges, tree.ends[leaf].vertex, feature.bridges, radius);
    const int order = found ? compare(depth, found->depth) : 1;
    if (order > 0) found = PocketMinimum{leaf, std::move(depth), false};
    if (order == 0) found->is_tie = true;
  }
  return found;
}

}  // namespace minkref::inline disc
