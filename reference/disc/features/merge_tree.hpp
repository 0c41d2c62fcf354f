// Features of P by radius, as a tree: where the points of the outer medial axis nearer to P than a
// radius fall into components, and where these become one (Behar & Lien 2012, Sec. 8.2).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// A feature from its birth on, or a component of the complement.
struct MergeNode {
  enum class Kind : std::uint8_t {
    reflex,   ///< a leaf: an end of the axis, where less than half a turn is free; born at 0
    minimum,  ///< a leaf: a place, or a flat ridge, from which the distance grows all ways
    merge,    ///< where features become one
    hole,     ///< a root: a bounded component of the complement, with its greatest distance
    outside,  ///< a root: the unbounded component; at infinity
  };
  Kind kind;
  std::uint32_t radius;  ///< number, as DiscIndex counts; 0 of a reflex end; infinity comes last
  /// Groups of nodes of the diagram's graph, each one place or one flat ridge, ascending; the
  /// groups by their first nodes. The outside: a group for each gap of the hull.
  std::vector<std::vector<std::uint32_t>> places;
  std::vector<std::uint32_t> children;  ///< ascending; none of a leaf
  std::uint32_t parent;                 ///< none of a root
};

/// A reflex end: a wedge of the complement.
struct ReflexEnd {
  Point vertex;     ///< in the frame of the curves
  Direction along;  ///< primitive, of the edge that leaves the vertex with the wedge on its right
};

struct MergeTree {
  static constexpr std::uint32_t none = UINT32_MAX;

  /// By radius, roots after others, then by the least place. Reflex ends: by coordinates, then by
  /// `along`. So children precede their parents.
  std::vector<MergeNode> nodes;
  /// The feature that each node of the graph belongs to, just above its radius.
  std::vector<std::uint32_t> feature_of;
  /// By tree node: halves that rise from graph nodes with this feature.
  std::vector<std::vector<std::uint32_t>> rising;
  std::vector<ReflexEnd> ends;  ///< of the first tree nodes

  bool is_reflex(std::uint32_t node) const { return node < ends.size(); }
  bool is_leaf(std::uint32_t node) const { return nodes[node].children.empty(); }
};

/// Finds the features at all radii. No tie is broken: features that become one at one radius, at
/// one place or several, have one node. Exact: radii are compared by number. O(n log n).
MergeTree merge_tree(const DiscIndex& index);

}  // namespace minkref::inline disc
