// The canonical form of a merge tree (docs/features.md).
#pragma once

#include <string>

#include "reference/disc/features/merge_tree.hpp"

namespace minkref::inline disc {

/// Writes the tree as JSON with rational numbers only: each place as its nearest features, as
/// docs/disc.md writes curves, and its number among the events with these features. The same for
/// each way to write P. O(n log n).
std::string canonical_json(const DiscIndex& index, const MergeTree& tree);

/// "reflex", "minimum", "merge", "hole" or "outside".
const char* name(MergeNode::Kind kind);

}  // namespace minkref::inline disc
