// Features of P by radius, as a tree: components among the outer medial axis's points nearer to P
// than a radius, and where components merge (Behar & Lien 2012, Sec. 8.2).
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
  /// Groups: the graph's nodes at a place or along a flat ridge, ascending; sorted by first node.
  /// The outside: a group for each hull gap.
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

  /// Sorted by radius, roots last, then by the least place; reflex ends by coordinates, then by
  /// `along`. So children precede their parents.
  std::vector<MergeNode> nodes;
  /// Each graph node's feature, just above the node's radius.
  std::vector<std::uint32_t> feature_of;
  /// Halves rising from graph nodes with a feature, by tree node.
  std::vector<std::vector<std::uint32_t>> rising;
  std::vector<ReflexEnd> ends;  ///< of the first tree nodes

  bool is_reflex(std::uint32_t node) const { return node < ends.size(); }
  bool is_leaf(std::uint32_t node) const { return nodes[node].children.empty(); }
};

/// Finds the features at all radii. Breaks no tie: features merging at a radius, whether at a
/// single place or at several, get a single node. Exact: compares numbers. O(n log n).
MergeTree merge_tree(const DiscIndex& index);

}  // namespace minkref::inline disc
