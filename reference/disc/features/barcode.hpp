// The bars of a merge tree: which feature lives on where features become one (the elder rule).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/features/bridge.hpp"
#include "reference/disc/features/merge_tree.hpp"

namespace minkref::inline disc {

/// A feature's life: it exists for birth < radius <= death.
struct FeatureBar {
  std::uint32_t leaf;          ///< tree node
  std::uint32_t birth, death;  ///< numbers of radii; infinity comes last
  std::uint32_t end;           ///< tree node at which the bar ends
  bool is_essential;           ///< the last bar of a component of the complement
  bool is_tie;                 ///< the least place decided at a node that it passes, or ends at
};

/// At each node the child whose elder leaf was born first lives on; if births are equal, the child
/// with the deeper elder leaf (leaf_depth.hpp); if depths are equal too, the child whose elder leaf
/// has the least place. The multiset of (birth, death) does not depend on these choices.
struct Barcode {
  std::vector<FeatureBar> bars;       ///< by leaf, in the order of the tree
  std::vector<std::uint32_t> elder;   ///< by tree node: the leaf that lives on, as a tree node
  std::vector<std::uint32_t> bar_of;  ///< by tree node: the bar of its elder leaf
  std::vector<char> is_tie;           ///< by tree node: the least place decided there
};

/// Exact. O(n log n), and O(b) for the b bridges of each feature that ends, if births are equal.
/// Throws LimitExceeded ("too-many-roots") where an equality of depths takes too many bits.
Barcode barcode(const Bridges& bridges, const MergeTree& tree);

}  // namespace minkref::inline disc
